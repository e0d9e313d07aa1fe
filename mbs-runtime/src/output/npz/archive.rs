//! A ZIP archive of files that are not compressed (APPNOTE.TXT of PKWARE, 4.3).

use std::io::{self, Seek, SeekFrom, Write};

const LOCAL: u32 = 0x0403_4b50;
const CENTRAL: u32 = 0x0201_4b50;
const END: u32 = 0x0605_4b50;
/// Version 2.0; names are UTF-8; not compressed; 1 January 1980.
const FORM: [u16; 5] = [20, 1 << 11, 0, 0, 1 << 5 | 1];
/// Bytes before the name in the two headers of a file, and at the end of the archive; those of a `.npy` header.
const FIXED: u64 = 30 + 46 + 128;

/// Whether an archive holds files of these names and this size: it counts bytes with 32 bits, files with 16.
pub(super) fn holds(names: &[String], size: u64) -> bool {
    let files = names
        .iter()
        .map(|name| size + FIXED + 2 * name.len() as u64 + 8);
    names.len() < usize::from(u16::MAX) && files.sum::<u64>() + 22 < u64::from(u32::MAX)
}

/// The CRC-32 of each byte.
const TABLE: [u32; 256] = {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut crc = byte as u32;
        let mut bit = 0;
        while bit < 8 {
            crc = (crc >> 1) ^ (0xedb8_8320 * (crc & 1));
            bit += 1;
        }
        table[byte] = crc;
        byte += 1;
    }
    table
};

/// A file of the archive.
struct Entry {
    name: String,
    /// Where its header begins.
    start: u32,
    crc: u32,
    size: u32,
}

/// The archive, and the file that is being written.
pub(super) struct Archive<W: Write + Seek> {
    out: W,
    entries: Vec<Entry>,
    /// Bytes so far.
    length: u32,
}

impl<W: Write + Seek> Archive<W> {
    pub(super) fn new(out: W) -> Self {
        Archive {
            out,
            entries: Vec::new(),
            length: 0,
        }
    }

    /// Begins a file.
    pub(super) fn begin(&mut self, name: &str) -> io::Result<()> {
        let entry = Entry {
            name: name.to_owned(),
            start: self.length,
            crc: 0,
            size: 0,
        };
        self.put(&local(&entry))?;
        self.entries.push(entry);
        Ok(())
    }

    /// Adds to this file.
    pub(super) fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.put(bytes)?;
        if let Some(entry) = self.entries.last_mut() {
            entry.size += bytes.len() as u32;
            entry.crc = !bytes.iter().fold(!entry.crc, |crc, &byte| {
                (crc >> 8) ^ TABLE[usize::from(crc as u8 ^ byte)]
            });
        }
        Ok(())
    }

    /// Ends this file: size and checksum are known now.
    pub(super) fn end(&mut self) -> io::Result<()> {
        let Some(entry) = self.entries.last() else {
            return Ok(());
        };
        self.out.seek(SeekFrom::Start(u64::from(entry.start)))?;
        self.out.write_all(&local(entry))?;
        self.out.seek(SeekFrom::Start(u64::from(self.length)))?;
        Ok(())
    }

    /// Writes the list of files.
    pub(super) fn finish(mut self) -> io::Result<()> {
        let start = self.length;
        let entries = std::mem::take(&mut self.entries);
        for entry in &entries {
            let mut header = Vec::new();
            header.extend(CENTRAL.to_le_bytes());
            header.extend(FORM[0].to_le_bytes());
            describe(&mut header, entry);
            // No comment; the first disk; no attributes.
            header.extend([0; 10]);
            header.extend(entry.start.to_le_bytes());
            header.extend(entry.name.as_bytes());
            self.put(&header)?;
        }
        let mut end = Vec::new();
        end.extend(END.to_le_bytes());
        // One disk, the first.
        end.extend([0; 4]);
        let count = entries.len() as u16;
        end.extend([count, count].map(u16::to_le_bytes).as_flattened());
        end.extend((self.length - start).to_le_bytes());
        end.extend(start.to_le_bytes());
        // No comment.
        end.extend([0; 2]);
        self.put(&end)?;
        self.out.flush()
    }

    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.out.write_all(bytes)?;
        self.length += bytes.len() as u32;
        Ok(())
    }
}

/// The header before a file.
fn local(entry: &Entry) -> Vec<u8> {
    let mut header = LOCAL.to_le_bytes().to_vec();
    describe(&mut header, entry);
    header.extend(entry.name.as_bytes());
    header
}

/// What both headers of a file have: form, checksum, size twice, length of the name, nothing else.
fn describe(header: &mut Vec<u8>, entry: &Entry) {
    header.extend(FORM.map(u16::to_le_bytes).as_flattened());
    for number in [entry.crc, entry.size, entry.size] {
        header.extend(number.to_le_bytes());
    }
    header.extend((entry.name.len() as u16).to_le_bytes());
    header.extend([0; 2]);
}
