package robotran.tinyvm

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.messages.UnsupportedFeature
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class VerifierTest {
    private fun shownBy(code: ClassAssembler.() -> List<Int>): List<Int> {
        val result = linkMain(code)
        val program = assertIs<TinyVmResult.Success>(result, result.toString()).program
        val rom = RecordingRom()
        assertEquals(ProgramStatus.Ended, program.start(rom).resume(100_000))
        return rom.shown
    }

    private fun assertUnsound(code: ClassAssembler.() -> List<Int>) {
        val refused = assertIs<TinyVmResult.Failure>(linkMain(code))
        assertEquals(TinyVmMessages.of(Language.ENGLISH).codeInvalid(), refused.refusal.message)
        assertEquals("main", refused.refusal.methodName)
    }

    @Test
    fun `a loop counts`() = // i = 0; sum = 0; do { sum += i; i++ } while (i < 100); show(sum)
        assertEquals(
            listOf(4950),
            shownBy {
                listOf(0x03, 0x3B, 0x03, 0x3C, 0x1B, 0x1A, 0x60, 0x3C, 0x84, 0, 1, 0x1A, 0x10, 100, 0xA1) + short(-10) +
                    0x1B +
                    show() +
                    0xB1
            },
        )

    @Test
    fun `a subroutine goes back to where it was called`() =
        // jsr S; jsr S; show(local 1); return; S: astore 2; iinc 1 5; ret 2
        assertEquals(
            listOf(10),
            shownBy {
                listOf(0x03, 0x3C, 0xA8) + short(11) + listOf(0xA8) + short(8) + 0x1B + show() + 0xB1 +
                    listOf(0x4D, 0x84, 1, 5, 0xA9, 2)
            },
        )

    @Test
    fun `decimals have the same bits everywhere`() =
        // show((int) (1 / 3f * 3000000)); 0f / 0f compared with itself counts as equal
        assertEquals(
            listOf(16960, 0),
            shownBy {
                listOf(0x0C, 0x12, decimal(3f), 0x6E, 0x12, decimal(3_000_000f), 0x6A, 0x8B) + show() +
                    listOf(0x0B, 0x0B, 0x6E, 0x0B, 0x95) + show() + 0xB1
            },
        )

    @Test
    fun `the smallest number divided by minus one stays`() = assertEquals(
        listOf(0, 0),
        shownBy {
            listOf(0x12, number(Int.MIN_VALUE), 0x02, 0x6C) + show() +
                listOf(0x12, number(Int.MIN_VALUE), 0x02, 0x70) +
                show() +
                0xB1
        },
    )

    @Test
    fun `a large step is done though leJOS knows no wide bytecodes`() = // i = 0; i += 1000; i += -2; show(i)
        assertEquals(
            listOf(998),
            shownBy {
                listOf(0x03, 0x3C, 0xC4, 0x84, 0, 1) + short(1000) + listOf(0xC4, 0x84, 0, 1) + short(-2) + 0x1B +
                    show() +
                    0xB1
            },
        )

    @Test
    fun `what leJOS refuses is refused with class and method`() {
        val refused = mapOf(
            listOf(0xBA, 0, 1, 0, 0) to UnsupportedFeature.INVOKE_DYNAMIC,
            listOf(0xC4, 0x15, 0, 1) to UnsupportedFeature.MANY_LOCALS,
            listOf(0xC4, 0x84, 1, 0, 0, 1) to UnsupportedFeature.MANY_LOCALS,
            listOf(0x13, 0, 1) to UnsupportedFeature.MANY_CONSTANTS,
            listOf(0xC8, 0, 0, 0, 5) to UnsupportedFeature.FAR_JUMP,
            listOf(0xAA) to UnsupportedFeature.SWITCH,
            listOf(0xAB) to UnsupportedFeature.SWITCH,
            listOf(0x61) to UnsupportedFeature.LONG_ARITHMETIC,
            listOf(0x94) to UnsupportedFeature.LONG_ARITHMETIC,
            listOf(0x72) to UnsupportedFeature.DECIMAL_REMAINDER,
            listOf(0x73) to UnsupportedFeature.DECIMAL_REMAINDER,
        )
        for ((code, feature) in refused) {
            val refusal = assertIs<TinyVmResult.Failure>(linkMain { code + 0xB1 }).refusal
            assertEquals(
                LinkError(TinyVmMessages.of(Language.ENGLISH).unsupportedFeature(feature), "Main", "main"),
                refusal,
            )
        }
    }

    @Test
    fun `taking from an empty stack is refused`() = assertUnsound { listOf(0x57, 0xB1) }

    @Test
    fun `a stack that overflows is refused`() = assertUnsound { List(9) { 0x03 } + 0xB1 }

    @Test
    fun `a number is no reference`() = assertUnsound { listOf(0x04, 0xBE, 0x57, 0xB1) }

    @Test
    fun `a reference is no number`() = assertUnsound { listOf(0x2A, 0x04, 0x60, 0x57, 0xB1) }

    @Test
    fun `a local without a value cannot be read`() = assertUnsound { listOf(0x1C, 0x57, 0xB1) }

    @Test
    fun `a local beyond the last is refused`() = assertUnsound { listOf(0x03, 0x36, 200, 0xB1) }

    @Test
    fun `code must not run off its end`() = assertUnsound { listOf(0x03, 0x57) }

    @Test
    fun `a jump into the middle of an instruction is refused`() = assertUnsound {
        listOf(0x10, 0, 0x57, 0xA7) +
            short(-2)
    }

    @Test
    fun `a jump out of the code is refused`() = assertUnsound { listOf(0xA7) + short(1000) }

    @Test
    fun `half of a long cannot be taken`() = assertUnsound { listOf(0x09, 0x57, 0x57, 0xB1) }

    @Test
    fun `a return address cannot be calculated with`() = assertUnsound {
        listOf(0xA8) + short(3) +
            listOf(0x04, 0x60, 0x57, 0xB1)
    }

    @Test
    fun `a loop that lets the stack grow is refused`() = assertUnsound { listOf(0x03, 0xA7) + short(-1) }

    @Test
    fun `a subroutine that calls itself for ever is refused or ends`() {
        val result = linkMain { listOf(0xA8) + short(0) }
        assertTrue(result is TinyVmResult.Failure)
    }

    @Test
    fun `a class that extends itself is refused`() {
        val loop = ClassAssembler("Main", "Main").apply {
            addMethod("main", "([Ljava/lang/String;)V", 0x9, listOf(0xB1))
        }
        val refused =
            assertIs<TinyVmResult.Failure>(
                linkTinyVm(
                    "Main",
                    mapOf("Main" to loop.assemble()),
                    minLibrary,
                    messages = TinyVmMessages.of(Language.ENGLISH),
                ),
            )
        assertEquals(TinyVmMessages.of(Language.ENGLISH).cyclicInheritance("Main"), refused.refusal.message)
    }

    @Test
    fun `a class file cut off anywhere is refused`() {
        val whole = ClassAssembler("Main", "java/lang/Object").apply {
            addMethod("main", "([Ljava/lang/String;)V", 0x9, listOf(0xB1))
        }.assemble()
        for (length in 0 until whole.size) {
            assertIs<TinyVmResult.Failure>(
                linkTinyVm(
                    "Main",
                    mapOf("Main" to whole.copyOf(length)),
                    minLibrary,
                    messages = TinyVmMessages.of(Language.ENGLISH),
                ),
            )
        }
    }
}
