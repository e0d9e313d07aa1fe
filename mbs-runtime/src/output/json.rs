//! The little JSON that an animation needs, safe inside a `<script>` element.

use std::fmt::Write as _;

/// A string literal. `<` is escaped, so that no text can close the element around it.
pub fn string(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' | '\0'..='\u{1f}' => {
                let _ = write!(out, "\\u{:04x}", c as u32);
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// An array of strings.
pub fn strings<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    array(texts.into_iter().map(string))
}

/// An array of values that are already JSON.
pub fn array(values: impl IntoIterator<Item = String>) -> String {
    let values: Vec<String> = values.into_iter().collect();
    format!("[{}]", values.join(","))
}

/// A number with `digits` decimals, without the zeros at its end; `null` where it is not finite.
pub fn number(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "null".to_owned();
    }
    let text = format!("{value:.digits$}");
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if text == "-0" { "0" } else { text }.to_owned()
}

/// A number with `digits` significant digits, in whichever form is shorter; `null` where it is not finite.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return number(value, 0);
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let mantissa = match mantissa.contains('.') {
        true => mantissa.trim_end_matches('0').trim_end_matches('.'),
        false => mantissa,
    };
    let decimals = digits as i32 - 1 - exponent.parse::<i32>().unwrap_or(0);
    let plain = number(value, decimals.max(0) as usize);
    let scientific = format!("{mantissa}e{exponent}");
    // Digits before the point are not rounded away.
    if decimals >= 0 && plain.len() <= scientific.len() {
        plain
    } else {
        scientific
    }
}

/// Decimals that show `scale` to about six digits.
pub fn digits_for(scale: f64) -> usize {
    if scale > 0.0 && scale.is_finite() {
        (6.0 - scale.log10().ceil()).clamp(0.0, 30.0) as usize
    } else {
        6
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_cannot_leave_the_script() {
        assert_eq!(
            string("a\"\\\n</script>"),
            "\"a\\\"\\\\\\u000a\\u003c/script\\u003e\""
        );
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(1.5, 6), "1.5");
        assert_eq!(number(-1e-9, 6), "0");
        assert_eq!(number(100.0, 0), "100");
        assert_eq!(number(f64::NAN, 3), "null");
        assert_eq!(significant(-0.5, 4), "-0.5");
        assert_eq!(significant(12.3456, 4), "12.35");
        assert_eq!(significant(-1.5e-12, 4), "-1.5e-12");
        assert_eq!(significant(123456.0, 4), "1.235e5");
        assert_eq!(significant(-0.0, 4), "0");
        assert_eq!(significant(f64::INFINITY, 4), "null");
        assert_eq!(digits_for(0.4), 6);
        assert_eq!(digits_for(250.0), 3);
    }
}
