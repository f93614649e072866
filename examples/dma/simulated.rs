//! A transfer by hardware, simulated: it takes the time that the bus takes, and the core is free to
//! do something else meanwhile.

use crate::board::meter::Instant;
use microraster::{Band, Rgb565};

/// Sends bands to a panel, one at a time. What it sends it owns: nobody draws there meanwhile.
pub(crate) struct SimulatedDma<'a> {
    running: Option<Transfer<'a>>,
    /// What the display shows.
    panel: &'a mut [u16],
    /// What simulating took, in instructions: hardware copies by itself.
    simulating: u64,
}

/// A band on its way.
struct Transfer<'a> {
    band: Band<'a, Rgb565>,
    began: Instant,
    /// How many instructions it takes, at one a cycle.
    takes: u64,
}

impl<'a> SimulatedDma<'a> {
    pub(crate) fn new(panel: &'a mut [u16]) -> Self {
        Self { running: None, panel, simulating: 0 }
    }

    /// Starts a transfer; the one before must be finished, as hardware wants it.
    pub(crate) fn start(&mut self, band: Band<'a, Rgb565>, cycles_per_pixel: u64) {
        let takes = band.pixels().len() as u64 * cycles_per_pixel;
        self.running = Some(Transfer { band, began: Instant::now(), takes });
    }

    /// Waits for the end of the transfer and gives its buffer back; `None` where there is none.
    pub(crate) fn finish(&mut self) -> Option<&'a mut [u16]> {
        let Transfer { band, began, takes } = self.running.take()?;
        while began.elapsed() < takes {}
        let copying = Instant::now();
        let sent = band.pixels();
        let first = usize::from(band.first_row()) * usize::from(band.size().width);
        if let Some(shown) = self.panel.get_mut(first..first + sent.len()) {
            shown.copy_from_slice(sent);
        }
        self.simulating += copying.elapsed();
        Some(band.into_buffer())
    }

    /// What the display shows.
    pub(crate) fn panel(&self) -> &[u16] {
        self.panel
    }

    /// Instructions since `began` without those that only simulating takes, of which there were
    /// `before` then.
    pub(crate) fn elapsed(&self, began: Instant, before: u64) -> u64 {
        began.elapsed().saturating_sub(self.simulating - before)
    }

    /// What simulating took so far, in instructions.
    pub(crate) fn simulating(&self) -> u64 {
        self.simulating
    }
}
