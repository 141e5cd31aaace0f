package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.link.Opcode
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.UnsupportedFeature
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** What the firmware cannot run although leJOS's own linker does not notice it, and class files that make no sense. */
class RefusedCodeTest {
    private val messages = ImageMessages.of(Language.ENGLISH)

    @Test
    fun `a text has at most 255 characters`() {
        assertEquals(emptyList(), errorsOf(linkText("x".repeat(255))))
        assertEquals(
            listOf("Main.main:7 ${messages.tinyVm.tooMany(Counted.TEXT_CHARACTERS, 255)}"),
            errorsOf(linkText("x".repeat(256))),
        )
    }

    @Test
    fun `each character of a text is one byte of the image`() {
        val image = assertIs<ImageResult.Success>(linkText("Grün 37")).image
        val bytes = image.contents.constants.single { it.bytes.size == 7 }.bytes
        assertEquals(listOf(0x47, 0x72, 0xFC, 0x6E, 0x20, 0x33, 0x37), bytes.map { it.toInt() and 0xFF })
    }

    @Test
    fun `a character that does not fit a byte is refused`() {
        assertEquals(listOf("Main.main:7 ${messages.strangeCharacter("€")}"), errorsOf(linkText("5 €")))
    }

    @Test
    fun `a native method that the firmware does not have is refused`() {
        fun link(name: String, descriptor: String) = linkMain {
            addMain()
            addMethod(name, descriptor, ClassWriter.NATIVE or ClassWriter.STATIC, null)
        }
        assertEquals(emptyList(), errorsOf(link("readByte", "(I)B")))
        assertEquals(listOf("Main.fly:0 ${messages.tinyVm.nativeMethod("fly")}"), errorsOf(link("fly", "()V")))
        assertEquals(
            listOf("Main.getMessage:0 ${messages.tinyVm.nativeMethod("getMessage")}"),
            errorsOf(link("getMessage", "()Ljava/lang/String;")),
        )
    }

    @Test
    fun `arrays of arrays of objects are not created at once`() {
        fun link(descriptor: String, dimensions: Int) = linkMain {
            addMain(listOf(4, 4, Opcode.MULTIANEWARRAY) + short(type(descriptor)) + dimensions + Opcode.POP)
        }
        assertEquals(emptyList(), errorsOf(link("[[I", 2)))
        assertEquals(emptyList(), errorsOf(link("[[[Ljava/lang/String;", 2)))
        assertEquals(
            listOf("Main.main:7 ${messages.arraysOfObjectArrays()}"),
            errorsOf(link("[[Ljava/lang/String;", 2)),
        )
    }

    @Test
    fun `a field is found in a superclass although leJOS looks only in the class that is named`() {
        val base = ClassWriter("Base").apply {
            addField("before", "B")
            addField("number", "I")
            addField("shared", "S", ClassWriter.STATIC)
        }
        val main = ClassWriter("Main", "Base").apply {
            addMain(
                listOf(1, Opcode.GETFIELD) + short(field("Main", "number", "I")) + Opcode.POP + Opcode.GETSTATIC +
                    short(field("Main", "shared", "S")) + Opcode.POP,
            )
        }
        val result =
            linkLejosImage(
                mapOf("Base" to base.bytes(), "Main" to main.bytes()),
                Vectors.library,
                listOf("Main"),
                messages = ImageMessages.of(Language.ENGLISH),
            )
        val image = assertIs<ImageResult.Success>(result).image
        val classes = image.contents.classes
        val code = image.bytes.drop(classes.single { it.name == "Main" }.methods.single().codeOffset)
        assertEquals(listOf(0xA0, 5), code.drop(2).take(2).map { it.toInt() and 0xFF })
        assertEquals(classes.indexOfFirst { it.name == "Base" }, code[6].toInt())
    }

    @Test
    fun `missing classes fields and methods are named with their line`() {
        assertEquals(
            listOf("Main.main:7 ${messages.tinyVm.classMissing("java.util.ArrayList")}"),
            errorsOf(linkMain { addMain(listOf(Opcode.NEW) + short(type("java/util/ArrayList")) + Opcode.POP) }),
        )
        assertEquals(
            listOf("Main:0 ${messages.tinyVm.classMissing("java.util.Map")}"),
            errorsOf(
                linkMain {
                    addMain()
                    type("java/util/Map")
                },
            ),
        )
        assertEquals(
            listOf("Shape:0 ${messages.tinyVm.classMissing("java.util.Map")}"),
            errorsOf(
                linkMain(mapOf("Shape" to ClassWriter("Shape", "java/util/Map").bytes())) {
                    addMain()
                    type("Shape")
                },
            ),
        )
        assertEquals(
            listOf("Main.main:7 ${messages.tinyVm.fieldMissing("java.lang.String", "size")}"),
            errorsOf(
                linkMain {
                    addMain(listOf(1, Opcode.GETFIELD) + short(field("java/lang/String", "size", "I")) + Opcode.POP)
                },
            ),
        )
        assertEquals(
            listOf("Main.main:7 ${messages.tinyVm.methodMissing("java.lang.String", "trim")}"),
            errorsOf(
                linkMain {
                    addMain(listOf(1, Opcode.INVOKEVIRTUAL) + short(method("java/lang/String", "trim", "()V")))
                },
            ),
        )
    }

    @Test
    fun `all mistakes of a program are told at once`() {
        val errors = errorsOf(
            linkMain {
                addMain(listOf(Opcode.WIDE, Opcode.IINC) + short(1) + short(-200) + listOf(9, 9, LADD, Opcode.POP2))
                addMethod("fly", "()V", ClassWriter.NATIVE, null)
            },
        )
        // Natives are checked before code, and code is not looked at if a table has mistakes.
        assertEquals(listOf("Main.fly:0 ${messages.tinyVm.nativeMethod("fly")}"), errors)
        val inCode = errorsOf(
            linkMain {
                addMain(listOf(Opcode.WIDE, Opcode.IINC) + short(1) + short(-200) + listOf(9, 9, LADD, Opcode.POP2))
            },
        )
        assertEquals(
            listOf(
                "Main.main:7 ${messages.largeStep("number", -200)}",
                "Main.main:7 ${messages.tinyVm.unsupportedFeature(UnsupportedFeature.LONG_ARITHMETIC)}",
            ),
            inCode,
        )
    }

    @Test
    fun `code in an interface is refused`() {
        val shape = ClassWriter("Shape", flags = ClassWriter.INTERFACE).apply {
            addMethod("area", "()V", 1, listOf(ClassWriter.RETURN))
        }
        assertEquals(
            listOf("Shape.area:0 ${messages.tinyVm.unsupportedFeature(UnsupportedFeature.INTERFACE_CODE)}"),
            errorsOf(
                linkMain(mapOf("Shape" to shape.bytes())) {
                    addMain(listOf(1, Opcode.INVOKEVIRTUAL) + short(method("Shape", "area", "()V")))
                },
            ),
        )
    }

    @Test
    fun `classes above themselves are refused`() {
        val egg = ClassWriter("Egg", "Hen").bytes()
        val hen = ClassWriter("Hen", "Egg").bytes()
        val errors = errorsOf(
            linkMain(mapOf("Egg" to egg, "Hen" to hen)) {
                addMain()
                type("Egg")
            },
        )
        assertEquals(listOf("Egg:0 ${messages.tinyVm.cyclicInheritance("Egg")}"), errors)
    }

    @Test
    fun `damaged class files are refused`() {
        val result =
            linkLejosImage(
                mapOf("Main" to byteArrayOf(1, 2, 3)),
                Vectors.library,
                listOf("Main"),
                messages = ImageMessages.of(Language.ENGLISH),
            )
        assertEquals("Main:0 ${messages.tinyVm.notAClassFile()}", errorsOf(result).first())
        val cut = errorsOf(linkMain { addMethod("main", "([Ljava/lang/String;)V", 9, listOf(Opcode.NEW, 0)) })
        assertEquals(listOf("Main.main:7 ${messages.tinyVm.codeInvalid()}"), cut)
    }

    @Test
    fun `without names the first class with a main method is started`() {
        val shape = ClassWriter("Shape").bytes()
        val main = ClassWriter("Main").apply { addMain() }.bytes()
        val result =
            linkLejosImage(
                mapOf("Shape" to shape, "Main" to main),
                Vectors.library,
                emptyList(),
                messages = ImageMessages.of(Language.ENGLISH),
            )
        assertEquals(listOf("Main"), assertIs<ImageResult.Success>(result).image.entryClasses)
    }

    @Test
    fun `nothing to start is refused`() {
        val nothing = mapOf("Shape" to ClassWriter("Shape").bytes())
        assertEquals(
            listOf("Shape:0 ${messages.tinyVm.noMainMethod()}"),
            errorsOf(
                linkLejosImage(nothing, Vectors.library, emptyList(), messages = ImageMessages.of(Language.ENGLISH)),
            ),
        )
        assertEquals(
            listOf("Missing:0 ${messages.tinyVm.noMainMethod()}"),
            errorsOf(
                linkLejosImage(
                    Vectors.programs,
                    Vectors.library,
                    listOf("Missing"),
                    messages = ImageMessages.of(Language.ENGLISH),
                ),
            ),
        )
    }

    private fun linkText(text: String) = linkMain { addMain(listOf(Opcode.LDC, string(text), Opcode.POP)) }

    private companion object {
        const val LADD = 97
    }
}
