package robotran.legofirmware.instructions

import robotran.legofirmware.Vectors
import robotran.legofirmware.image.CodeBytes
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class InstructionTest {
    @Test
    fun `the number of operand bytes is in the low bits of the opcode`() {
        for (opcode in Opcode.entries) {
            val expected = when (opcode) {
                Opcode.CHK -> 6
                Opcode.CHKL -> 7

                else -> when (val low = opcode.code and 7) {
                    6 -> 0
                    7 -> 1
                    else -> low
                }
            }
            assertEquals(1 + expected, opcode.size, "$opcode")
        }
    }

    @Test
    fun `instructions of the original compiler are decoded and encoded byte for byte`() {
        for (name in Vectors.names) {
            for (chunk in Vectors.image(name).chunks) {
                var address = 0
                while (address < chunk.code.size) {
                    val placed = assertNotNull(chunk.code.instructionAt(address), "$name ${chunk.id} $address")
                    val bytes = CodeBytes(chunk.code.toByteArray().copyOfRange(address, placed.end))
                    assertEquals(bytes, placed.instruction.encode(address), "$name ${chunk.id} $address")
                    address = placed.end
                }
            }
        }
    }

    @Test
    fun `jumps count from their first offset byte`() {
        assertEquals(27, CodeBytes(ByteArray(6) + bytes(0x27, 0x14)).instructionAt(6)?.instruction?.target)
        assertEquals(CodeBytes.of(0x27, 0x9B), Instruction(Opcode.JMP, Operand.Address(53)).encode(79))
        assertEquals(CodeBytes.of(0x72, 0x85, 0x02), Instruction(Opcode.JMPL, Operand.Address(0)).encode(260))
        assertEquals(CodeBytes.of(0x72, 0x05, 0x02), Instruction(Opcode.JMPL, Operand.Address(262)).encode(0))
        val far = CodeBytes(ByteArray(260) + bytes(0x72, 0x85, 0x02))
        assertEquals(0, far.instructionAt(260)?.instruction?.target)
        assertTrue(Opcode.JMP.reaches(0, 128))
        assertFalse(Opcode.JMP.reaches(0, 129))
        assertTrue(Opcode.JMP.reaches(126, 0))
        assertFalse(Opcode.JMP.reaches(127, 0))
        assertTrue(Opcode.CHK.reaches(0, 261))
        assertFalse(Opcode.CHK.reaches(0, 5))
        assertEquals(Opcode.CHKL, Opcode.CHK.longForm)
    }

    @Test
    fun `every form holds every distance that it reaches`() {
        for (form in JumpForm.entries) {
            for (distance in form.reach) {
                val encoded = form.encode(BASE, BASE + distance)
                assertTrue(encoded in 0 until (1 shl 8 * form.size), "$form $distance")
                assertEquals(BASE + distance, form.decode(BASE, encoded), "$form $distance")
            }
        }
    }

    @Test
    fun `toggled opcodes are the same commands unless they are for programs only`() {
        assertEquals(Opcode.PLAYS, Opcode.of(0x59))
        assertEquals(Opcode.PLAYS, Opcode.of(0x51))
        assertNull(Opcode.of(0x2F))
        assertNull(CodeBytes.of(0x51).instructionAt(0))
        assertNull(CodeBytes.of(0x00, 0x00).instructionAt(0))
        assertNull(CodeBytes.of(0x10).instructionAt(1))
    }

    private fun bytes(vararg numbers: Int): ByteArray = CodeBytes.of(*numbers).toByteArray()

    private companion object {
        const val BASE = 100_000
    }
}
