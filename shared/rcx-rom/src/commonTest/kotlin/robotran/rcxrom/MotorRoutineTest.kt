package robotran.rcxrom

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.log.CallOutcome
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.controls.romCode
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals

class MotorRoutineTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    @Test
    fun `each mode sets the two direction bits of its motor and of no other`() {
        val directionBits = mapOf(
            MotorMode.FORWARD to 2,
            MotorMode.BACKWARD to 1,
            MotorMode.BRAKE to 3,
            MotorMode.FLOAT to 0,
        )
        val shifts = mapOf(MotorPort.A to 6, MotorPort.B to 2, MotorPort.C to 0)
        for ((port, shift) in shifts) {
            for ((mode, bits) in directionBits) {
                val fresh = Hardware(messages = BrickMessages.of(Language.ENGLISH))
                fresh.control(port, mode.code, 7)
                fresh.tick()
                assertEquals(bits shl shift, fresh.memory.readByte(0xEFCA), "directions for $port $mode")
                assertEquals(bits shl shift, fresh.memory.readByte(0xF000), "latch for $port $mode")
                assertEquals(bits shl shift, fresh.memory.readByte(0xEFCE), "shadow for $port $mode")
                assertEquals(mode, fresh.motors.output(port))
            }
        }
    }

    @Test
    fun `the log tells motor and mode and power in words`() {
        assertEquals("0 0x1a4e 0x2000 1 3 ; motor A forward 3 ; 7", hardware.control(MotorPort.A, 1, 3).text)
        assertEquals("0 0x1a4e 0x2001 2 0 ; motor B backward 0 ; 7", hardware.control(MotorPort.B, 2, 0).text)
        assertEquals("0 0x1a4e 0x2002 3 7 ; motor C brake 7 ; 7", hardware.control(MotorPort.C, 3, 7).text)
        assertEquals("0 0x1a4e 0x2002 4 5 ; motor C float 5 ; 7", hardware.control(MotorPort.C, 4, 5).text)
    }

    @Test
    fun `power is taken modulo 8`() {
        val powers = mapOf(8 to 0, 11 to 3, 15 to 7, 255 to 7, -1 to 7, -8 to 0, 32_767 to 7)
        for ((given, taken) in powers) {
            val entry = hardware.control(MotorPort.A, 1, given)
            assertEquals(taken, hardware.motors.states[0].power)
            assertEquals("motor A forward $taken, power $given counts as $taken", entry.meaning)
        }
    }

    @Test
    fun `an unknown mode leaves the mode and sets the power`() {
        hardware.control(MotorPort.A, 2, 3)
        val entry = hardware.control(MotorPort.A, 9, 5)
        assertEquals(MotorState(MotorPort.A, MotorMode.BACKWARD, 5), hardware.motors.states[0])
        assertEquals("motor A backward 5, mode 9 is ignored", entry.meaning)
    }

    @Test
    fun `an unknown motor is reported and changes nothing`() {
        val before = hardware.motors.states
        val entry = hardware.call(RomAddress.CONTROL_MOTOR, 0x2003, 1, 3)
        assertEquals(CallOutcome.WRONG_ARGUMENTS, entry.outcome)
        assertEquals("0 0x1a4e 0x2003 1 3 ; nothing happens, there is no code 0x2003 here ; 7", entry.text)
        assertEquals(before, hardware.motors.states)
    }

    @Test
    fun `a power of n switches the port on in n plus 1 of 8 milliseconds and lets it coast in the others`() {
        val patterns =
            listOf("10000000", "10001000", "10010010", "10101010", "10110110", "11101110", "11111110", "11111111")
        patterns.forEachIndexed { power, pattern ->
            val fresh = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            fresh.control(MotorPort.B, MotorMode.FORWARD.code, power)
            assertEquals(pattern + pattern, fresh.slots(MotorPort.B, 16), "power $power")
            assertEquals(power + 1, pattern.count { it == '1' })
        }
    }

    @Test
    fun `a brake is pulsed by its power as well`() {
        hardware.control(MotorPort.C, MotorMode.BRAKE.code, 0)
        assertEquals("10000000", hardware.slots(MotorPort.C, 8))
    }

    @Test
    fun `a motor told to drive for 400 milliseconds is driven for 400`() {
        hardware.control(MotorPort.A, MotorMode.FORWARD.code, 7)
        var driven = 0
        repeat(1_000) { millisecond ->
            if (millisecond == 400) hardware.control(MotorPort.A, MotorMode.BRAKE.code, 7)
            hardware.tick()
            if (hardware.motors.output(MotorPort.A) == MotorMode.FORWARD) driven++
        }
        assertEquals(400, driven)
    }

    private fun Hardware.control(port: MotorPort, mode: Int, power: Int) =
        call(RomAddress.CONTROL_MOTOR, port.romCode, mode, power)

    private fun Hardware.slots(port: MotorPort, milliseconds: Int): String = (1..milliseconds).joinToString("") {
        tick()
        if (motors.output(port) == MotorMode.FLOAT) "0" else "1"
    }
}
