package robotran.tinyvm.programs

import kotlin.test.Test

/** Programs that wait for answers through the air, which takes half a minute as wasm. */
class InfraredProgramsTest {
    @Test
    fun `programs about infrared do what they say`() = doWhatTheySay("rcxcomm")
}
