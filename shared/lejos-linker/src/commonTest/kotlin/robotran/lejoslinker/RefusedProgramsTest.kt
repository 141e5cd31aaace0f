package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.messages.ImageMessages
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.messages.UnsupportedFeature
import kotlin.test.Test
import kotlin.test.assertEquals

/** The programs that leJOS's own linker refuses; it says only the instruction and the method. */
class RefusedProgramsTest {
    @Test
    fun `a large step names the variable and says what to write instead`() {
        val sentence = "The brick adds only numbers from -128 to 127 this way."
        assertRefused("WideIncrement", "WideIncrement.main:5 $sentence Write \"a = a + 1000\".")
        assertRefused("Increment", "Increment.main:5 $sentence Write \"a = a + 200\".")
    }

    @Test
    fun `a small step is linked`() {
        assertRefused("SmallIncrement")
    }

    @Test
    fun `Java that the brick does not have is refused with its line`() {
        assertUnsupported("Switch", UnsupportedFeature.SWITCH)
        assertUnsupported("SparseSwitch", UnsupportedFeature.SWITCH)
        assertUnsupported("LongSum", UnsupportedFeature.LONG_ARITHMETIC)
        assertUnsupported("LongCompare", UnsupportedFeature.LONG_ARITHMETIC)
        assertUnsupported("FloatRemainder", UnsupportedFeature.DECIMAL_REMAINDER)
        assertUnsupported("ArrayCast", UnsupportedFeature.ARRAY_TEST)
        assertUnsupported("ArrayTest", UnsupportedFeature.ARRAY_TEST)
    }

    @Test
    fun `a class with too many constants is refused at each line that code cannot reach`() {
        val errors = errorsOf(linkVector("ManyConstants", programs = Vectors.refused))
        val inClass = TinyVmMessages.of(Language.ENGLISH).unsupportedFeature(UnsupportedFeature.MANY_CONSTANTS)
        val inProgram = ImageMessages.of(Language.ENGLISH).tooManyConstants(322, 256)
        assertEquals(setOf(inClass, inProgram), errors.map { it.substringAfter(' ') }.toSet())
        assertEquals(errors.distinct(), errors)
    }

    @Test
    fun `a method with too many variables is refused`() {
        val errors = errorsOf(linkVector("ManyLocals", programs = Vectors.refused))
        assertEquals(
            "ManyLocals.main:0 " + TinyVmMessages.of(Language.ENGLISH).tooMany(Counted.LOCALS, 255),
            errors.first(),
        )
    }

    @Test
    fun `a class without main cannot be started`() {
        assertRefused("NoMain", "NoMain:0 ${TinyVmMessages.of(Language.ENGLISH).noMainMethod()}")
    }

    private fun assertUnsupported(program: String, feature: UnsupportedFeature) =
        assertRefused(program, "$program.main:5 ${TinyVmMessages.of(Language.ENGLISH).unsupportedFeature(feature)}")

    private fun assertRefused(program: String, vararg errors: String) =
        assertEquals(errors.toList(), errorsOf(linkVector(program, programs = Vectors.refused)))
}
