package robotran.tinyvm.programs

import kotlin.test.Test

/** Programs that run for very long or fill the memory, which takes a minute as wasm. */
class LimitProgramsTest {
    @Test
    fun `programs about the limits of a brick do what they say`() = doWhatTheySay("limits")
}
