//! What the search over the parameters of the baselines found.

use super::data::Data;
use crate::laboratory::tuning::table as markdown;

pub fn table(data: &Data) -> Result<String, String> {
    Ok(markdown(&data.table("tuning.csv")?.rows))
}
