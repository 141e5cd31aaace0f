plugins {
    id("robotran.wasm-tests")
}
