package robotran.rcxrom

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.Exhaustive
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import io.kotest.property.exhaustive.ints
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.call.RomTable
import robotran.rcxrom.log.RomLogEntry
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sound.Speaker
import kotlin.math.abs

private val WORDS = 0..0xFFFF
private const val NUMBERS_SHOWN = 20_000

class RomProperties :
    StringSpec({
        val anyAddress = Arb.choice(Arb.int(WORDS), Arb.element(RomTable.signatures.map { it.address }))
        val anyGroup = Arb.element(RomTable.signatures.mapNotNull { it.codeGroup })
        val anyCode = Arb.bind(anyGroup, Arb.int(0..0x30)) { group, low -> (group shl 8) + low }
        val anyArgument = Arb.choice(Arb.int(WORDS), Arb.int(-10..10))

        "a number of the whole range reads back as itself or as the nearest that fits, with every decimal point" {
            val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            val points = mapOf(
                RomCode.LCD_POINT_NONE to 0,
                RomCode.LCD_POINT_1 to 1,
                RomCode.LCD_POINT_2 to 2,
                RomCode.LCD_POINT_3 to 3,
            )
            for (number in -NUMBERS_SHOWN..NUMBERS_SHOWN) {
                for ((point, decimals) in points) {
                    val fitting = number.coerceIn(-9999, 9999).toBigDecimal().movePointLeft(decimals).setScale(decimals)
                    hardware.shown(RomCode.LCD_SIGNED, number, point).toBigDecimal() shouldBe fitting
                }
            }
        }

        "an unsigned number of the whole range reads back with four digits" {
            val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            checkAll(Exhaustive.ints(-NUMBERS_SHOWN..NUMBERS_SHOWN)) { number ->
                hardware.shown(RomCode.LCD_UNSIGNED, number, RomCode.LCD_POINT_NONE) shouldBe
                    (number and 0xFFFF).coerceAtMost(9999).toString().padStart(4, '0')
            }
        }

        "any address with any arguments is logged and never throws" {
            val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            checkAll(iterations = 20_000, anyAddress, Arb.list(anyArgument, 0..4)) { address, arguments ->
                val before = hardware.log.total
                hardware.rom.call(RomCall(address, arguments), TEST_LINE)
                hardware.tick()
                hardware.log.total shouldBe before + 1
                (hardware.log.entries.last() as RomLogEntry).run {
                    call shouldBe RomCall(address, arguments)
                    text.endsWith("; $meaning ; $TEST_LINE") shouldBe true
                }
                hardware.speaker.waitingCount shouldBeInRange 0..Speaker.QUEUE_CAPACITY
            }
        }

        "any code near the known ones is answered without throwing" {
            val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            checkAll(iterations = 20_000, anyAddress, anyCode, Arb.list(anyArgument, 2..3)) { address, code, others ->
                val before = hardware.log.total
                hardware.rom.call(RomCall(address, listOf(code) + others), TEST_LINE)
                hardware.lcd.refresh()
                hardware.lcd.glass.text.length shouldBeInRange 0..10
                hardware.log.total shouldBe before + 1
            }
        }

        "a motor's power is on for power plus 1 of any 8 milliseconds" {
            checkAll(Exhaustive.ints(0..7), Exhaustive.ints(0..9)) { power, delay ->
                val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
                hardware.call(RomAddress.CONTROL_MOTOR, 0x2001, MotorMode.FORWARD.code, power)
                repeat(delay) { hardware.tick() }
                val on = (1..8).count {
                    hardware.tick()
                    hardware.motors.output(MotorPort.B) == MotorMode.FORWARD
                }
                on shouldBe power + 1
            }
        }

        "the real frequency of a tone is as near as the timer's counts allow" {
            checkAll(Exhaustive.ints(31..20_000)) { hertz ->
                val real = checkNotNull(realHertz(hertz))
                (real >= hertz) shouldBe true
                (abs(real - hertz) / hertz < 0.02) shouldBe true
            }
        }
    })

private fun Hardware.shown(code: Int, number: Int, point: Int): String {
    call(RomAddress.SET_LCD_NUMBER, code, number, point)
    lcd.refresh()
    return lcd.glass.number
}
