//! The least that firmware needs: what happens on a panic. The size proofs use it, so that
//! printing is not part of what is weighed.

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
