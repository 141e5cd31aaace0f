package robotran.tinyvm

import robotran.language.Language
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.messages.UnsupportedFeature
import robotran.tinyvm.programs.libraryClassFiles
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LinkErrorTest {
    private fun refused(body: String, members: String = "") = refusal(program(body, members))

    @Test
    fun `a switch is refused with its class method and line`() {
        val refusal = refused("int x = 3;\nswitch (x) { case 1: show(1); default: }")
        assertEquals("Program", refusal.className)
        assertEquals("main", refusal.methodName)
        assertEquals(5, refusal.sourceLine)
        assertEquals("The brick does not know \"switch\". Use \"if\" and \"else if\" instead.", refusal.message)
    }

    @Test
    fun `what a TinyVM lacks is refused`() {
        val messages = TinyVmMessages.of(Language.ENGLISH)
        assertEquals(
            messages.unsupportedFeature(UnsupportedFeature.LONG_ARITHMETIC),
            refused("long a = 1; a = a + 1;").message,
        )
        assertEquals(
            messages.unsupportedFeature(UnsupportedFeature.LONG_ARITHMETIC),
            refused("long a = 1; show(a < 2);").message,
        )
        assertEquals(
            messages.unsupportedFeature(UnsupportedFeature.DECIMAL_REMAINDER),
            refused("float a = 1; a %= 2;").message,
        )
        assertEquals(
            messages.unsupportedFeature(UnsupportedFeature.ARRAY_TEST),
            refused("Object a = new int[1]; show(((int[]) a).length);").message,
        )
        assertEquals(
            messages.unsupportedFeature(UnsupportedFeature.CLASS_LITERAL),
            refused("Object a = String.class;").message,
        )
        assertEquals(
            messages.unsupportedFeature(UnsupportedFeature.INTERFACE_CODE),
            refused(
                "new A() {}.a();",
                "interface A { default void a() {} " +
                    "}",
            ).message,
        )
        val parameters = (1..17).joinToString { "int p$it" }
        assertEquals(messages.tooMany(Counted.PARAMETERS, 16), refused("", "static void many($parameters) {}").message)
        assertEquals(messages.nativeMethod("own"), refused("own();", "static native void own();").message)
    }

    @Test
    fun `a program without main is refused`() = assertEquals(
        TinyVmMessages.of(Language.ENGLISH).noMainMethod(),
        refusal("class Program { void main() {} }").message,
    )

    @Test
    fun `no bytes at all and other bytes are refused`() {
        for (bytes in listOf(ByteArray(0), ByteArray(100), "PK archive".encodeToByteArray())) {
            assertIs<TinyVmResult.Failure>(
                linkTinyVm("x", mapOf("X" to bytes), libraryClassFiles, messages = TinyVmMessages.of(Language.ENGLISH)),
            )
        }
    }

    @Test
    fun `a class the library lacks is named`() {
        val library = libraryClassFiles - "josx/platform/rcx/ROM"
        val result =
            linkTinyVm(
                "x",
                JavaCompiler.compile(program("show(1);")),
                library,
                messages = TinyVmMessages.of(Language.ENGLISH),
            )
        assertEquals(
            "There is no class josx.platform.rcx.ROM on the brick.",
            assertIs<TinyVmResult.Failure>(result).refusal.message,
        )
    }
}
