package robotran.lejoslinker

import robotran.language.Language
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.messages.ImageMessages
import robotran.lejoslinker.messages.tinyVm
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.link.Opcode
import robotran.tinyvm.messages.Counted
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class LimitsTest {
    private val messages = ImageMessages.of(Language.ENGLISH)

    @Test
    fun `the last class that fits has number 255`() {
        val least = assertIs<ImageResult.Success>(linkMain { addMain() }).image.contents.classes.size
        assertIs<ImageResult.Success>(linkWithClasses(256 - least))
        assertEquals(
            listOf("Main:0 ${messages.tooManyClasses(257, 256)}"),
            errorsOf(linkWithClasses(257 - least)),
        )
    }

    @Test
    fun `code loads constants up to number 255`() {
        val others = assertIs<ImageResult.Success>(linkWithLast {}).image.contents.constants.size

        fun link(count: Int) = linkWithLast {
            repeat(count - 1) { number(it + 100_000) }
            addLast(listOf(Opcode.LDC, number(1_000_000), Opcode.POP))
        }
        assertEquals(emptyList(), errorsOf(link(256 - others)))
        assertEquals(
            listOf("Last.<clinit>:7 ${messages.tooManyConstants(257, 256)}"),
            errorsOf(link(257 - others)),
        )
    }

    @Test
    fun `code cannot reach a static field beyond number 255`() {
        val others = assertIs<ImageResult.Success>(linkWithLast {}).image.contents.staticFields.size

        fun link(count: Int) = linkWithLast {
            repeat(count) { addField("f$it", "B", ClassWriter.STATIC) }
            addLast(listOf(Opcode.GETSTATIC) + short(field("Last", "f${count - 1}", "B")) + Opcode.POP)
        }
        assertEquals(emptyList(), errorsOf(link(256 - others)))
        assertEquals(
            listOf("Last.<clinit>:7 ${messages.tooManyStaticFields(257, 256)}"),
            errorsOf(link(257 - others)),
        )
    }

    @Test
    fun `a constant of the library that the program pushes out of reach is told at the main class`() {
        val errors = errorsOf(
            linkMain {
                addMain()
                repeat(255) { number(it + 100_000) }
            },
        )
        assertEquals(listOf("Main:0"), errors.map { it.substringBefore(' ') })
    }

    @Test
    fun `static fields take at most 4096 bytes`() {
        val holders = (1..3).associate { number ->
            "Holder$number" to
                ClassWriter("Holder$number").apply { repeat(200) { addField("f$it", "J", ClassWriter.STATIC) } }
                    .bytes()
        }
        val errors = errorsOf(
            linkMain(holders) {
                addMain()
                holders.keys.forEach(::type)
            },
        )
        val before = assertIs<ImageResult.Success>(linkMain { addMain() }).image.contents.staticStateBytes
        assertEquals(listOf("Main:0 ${messages.tooManyStaticBytes(before + 4800, 4096)}"), errors)
    }

    @Test
    fun `fields of an object are reached up to byte 4095`() {
        val chain = (1..3).associate { number ->
            val superName = if (number == 1) "java/lang/Object" else "Part${number - 1}"
            "Part$number" to
                ClassWriter("Part$number", superName).apply { repeat(200) { addField("f$it", "D") } }.bytes()
        }
        assertEquals(
            listOf("Part3:0 ${messages.objectTooLarge(4800, 4095)}"),
            errorsOf(
                linkMain(chain) {
                    addMain()
                    type("Part3")
                },
            ),
        )
    }

    @Test
    fun `a class has at most 255 fields and 255 methods`() {
        assertEquals(
            listOf("Main:0 ${messages.tinyVm.tooMany(Counted.FIELDS, 255)}"),
            errorsOf(
                linkMain {
                    addMain()
                    repeat(256) { addField("f$it", "B") }
                },
            ),
        )
        assertEquals(
            listOf("Main:0 ${messages.tinyVm.tooMany(Counted.METHODS, 255)}"),
            errorsOf(
                linkMain {
                    addMain()
                    repeat(255) { addMethod("m$it", "()V", 0, listOf(ClassWriter.RETURN)) }
                },
            ),
        )
    }

    @Test
    fun `a method has at most 16 words of parameters`() {
        fun link(descriptor: String, flags: Int) = linkMain {
            addMain()
            addMethod("m", descriptor, flags, listOf(ClassWriter.RETURN), locals = 20)
        }
        assertEquals(emptyList(), errorsOf(link("(JJJJJJJI)V", 0)))
        assertEquals(emptyList(), errorsOf(link("(JJJJJJJJ)V", ClassWriter.STATIC)))
        assertEquals(
            listOf("Main.m:0 ${messages.tinyVm.tooMany(Counted.PARAMETERS, 16)}"),
            errorsOf(link("(JJJJJJJJ)V", 0)),
        )
    }

    @Test
    fun `a method has at most 255 words of operands and 255 handlers`() {
        assertEquals(
            listOf("Main.m:0 ${messages.tinyVm.tooMany(Counted.OPERANDS, 255)}"),
            errorsOf(
                linkMain {
                    addMain()
                    addMethod("m", "()V", 0, listOf(ClassWriter.RETURN), stack = 256)
                },
            ),
        )
        val handlers = List(256) { listOf(0, 1, 0, 0) }
        assertEquals(
            listOf("Main.m:0 ${messages.tinyVm.tooMany(Counted.HANDLERS, 255)}"),
            errorsOf(
                linkMain {
                    addMain()
                    addMethod("m", "()V", 0, listOf(ClassWriter.RETURN), handlers = handlers)
                },
            ),
        )
    }

    @Test
    fun `at most 4096 signatures have numbers`() {
        val few = assertIs<ImageResult.Success>(linkWithSignatures(0)).image.contents.signatures.size
        val errors = errorsOf(linkWithSignatures(250))
        assertEquals(listOf("Many0:0 ${messages.tooManySignatures(few + 17 * 250, 4096)}"), errors)
    }

    @Test
    fun `an image that leaves no room for the first objects is refused`() {
        val maxBytes = BrickRoom.V3_0.maxImageBytes
        val small = assertIs<ImageResult.Success>(linkWithCode(0)).image.bytes.size
        val largest = assertIs<ImageResult.Success>(linkWithCode(maxBytes - small))
        assertEquals(maxBytes, largest.image.bytes.size)
        assertEquals(listOf(messages.littleMemory(13888 - maxBytes)), largest.warnings)
        assertEquals(
            listOf("Main:0 ${messages.imageTooLarge(maxBytes + 1, maxBytes)}"),
            errorsOf(linkWithCode(maxBytes - small + 1)),
        )
    }

    @Test
    fun `leJOS 2_1 leaves more room than 3_0`() {
        val small = assertIs<ImageResult.Success>(linkWithCode(0)).image.bytes.size
        val room = BrickRoom.V2_1.maxImageBytes
        val options = ImageOptions(version = LejosVersion.V2_1)
        assertEquals(emptyList(), errorsOf(linkWithCode(room - small, options)))
        assertEquals(1, errorsOf(linkWithCode(room - small)).size)
    }

    @Test
    fun `a small program has no warning`() {
        val linked = assertIs<ImageResult.Success>(linkMain { addMain() })
        assertEquals(emptyList(), linked.warnings)
        assertEquals(13888 - linked.image.bytes.size, linked.image.bytesForObjects(LejosVersion.V3_0))
    }

    private fun linkWithClasses(count: Int): ImageResult {
        val others = (1..count).associate { "Other$it" to ClassWriter("Other$it").bytes() }
        return linkMain(others) {
            addMain()
            others.keys.forEach(::type)
        }
    }

    /** Links a program whose class `Last`, which [write] describes, has the highest number of all. */
    private fun linkWithLast(write: ClassWriter.() -> Unit): ImageResult {
        val names = (1..STEPS).map { "Step$it" } + "Last"
        val steps = names.zipWithNext { name, next -> name to ClassWriter(name).apply { type(next) }.bytes() }
        val last = "Last" to ClassWriter("Last").apply(write).bytes()
        return linkMain(steps.toMap() + last) {
            addMain()
            type(names.first())
        }
    }

    private fun ClassWriter.addLast(code: List<Int>) {
        // A class initializer is kept although nothing calls it.
        addMethod("<clinit>", "()V", ClassWriter.STATIC, code + ClassWriter.RETURN)
    }

    private fun linkWithCode(bytes: Int, options: ImageOptions = ImageOptions()): ImageResult =
        linkMain(options = options) { addMain(List(bytes) { 0 }) }

    private fun linkWithSignatures(ofEach: Int): ImageResult {
        val classes = (0 until 17).associate { number ->
            val writer = ClassWriter("Many$number")
            writer.addMain()
            repeat(ofEach) { writer.addMethod("m${number}x$it", "()V", ABSTRACT, null) }
            "Many$number" to writer.bytes()
        }
        return linkLejosImage(
            classes,
            Vectors.library,
            classes.keys.toList(),
            messages = ImageMessages.of(Language.ENGLISH),
        )
    }

    private companion object {
        /** More than the longest chain of names between classes of the library. */
        const val STEPS = 20
        const val ABSTRACT = 0x400
    }
}
