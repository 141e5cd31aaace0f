package robotran.rcxrom

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.Exhaustive
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import io.kotest.property.exhaustive.ints
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sensors.Battery
import robotran.rcxrom.sensors.RotationSensor
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorMode
import robotran.rcxrom.sensors.SensorReading
import robotran.rcxrom.sensors.SensorRequest
import robotran.rcxrom.sound.Speaker
import kotlin.math.abs

private val RAW = 0..1023

class FormulaProperties :
    StringSpec({
        "percent never rises with the raw value but at its quirk, and is the ROM's fraction" {
            checkAll(Exhaustive.ints(RAW)) { raw ->
                val percent = SensorReading.percent(raw)
                percent shouldBeInRange 0..101
                if (raw != 390 && raw < 1023) (SensorReading.percent(raw + 1) <= percent) shouldBe true
                if (raw >= 391) percent shouldBe (1023 - raw) * 25 / 156
                (percent == 101) shouldBe (raw in 391..392)
            }
        }

        "temperature falls as the raw value rises, but for the seams of its pieces, and Fahrenheit follows Celsius" {
            checkAll(Exhaustive.ints(RAW)) { raw ->
                val celsius = SensorReading.celsius(raw)
                val isThere = raw in 290..927
                (celsius != SensorReading.NO_TEMPERATURE) shouldBe isThere
                if (isThere) {
                    celsius shouldBeInRange -200..700
                    abs(SensorReading.fahrenheit(raw) - (celsius * 9.0 / 5 + 320)) shouldBeLess 1.0
                    if (raw < 927) (celsius - SensorReading.celsius(raw + 1)) shouldBeInRange -3..5
                } else {
                    SensorReading.fahrenheit(raw) shouldBe SensorReading.NO_TEMPERATURE
                }
            }
        }

        "the boolean value is low or high at the ends, and with a slope follows jumps" {
            checkAll(Exhaustive.ints(0..31)) { slope ->
                for (raw in RAW step 3) {
                    for (rawBefore in RAW step 11) {
                        for (before in 0..1) {
                            val boolean = SensorReading.boolean(raw, before, rawBefore, SensorMode.BOOLEAN.code + slope)
                            val expected = when {
                                slope == 0 && raw < 460 -> 1
                                slope == 0 && raw >= 564 -> 0
                                slope == 0 -> before
                                raw < slope -> 1
                                raw > 1023 - slope -> 0
                                raw <= rawBefore - slope -> 1
                                raw > rawBefore + slope -> 0
                                else -> before
                            }
                            boolean shouldBe expected
                        }
                    }
                }
            }
        }

        "a rotation sensor counts any walk of its axle, however it turns" {
            checkAll(iterations = 200, Arb.list(Arb.int(0..1).map { 2 * it - 1 }, 1..60)) { steps ->
                val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
                hardware.rom.setSensorTypeAndMode(2, 4, SensorMode.ANGLE.code)
                var count = 0
                val turnTo = { place: Int ->
                    hardware.sensors.measure(2, RotationSensor.raw(place, active = true))
                    hardware.tick(6)
                }
                turnTo(0)
                hardware.rom.setSensorValue(2, 0, SensorField.VALUE)
                for (step in steps) {
                    count += step
                    turnTo(count)
                }
                hardware.rom.readSensor(2, SensorRequest.CANONICAL) shouldBe steps.sum()
            }
        }

        "edges and presses are counted as they come if none is within the debounce of another" {
            checkAll(iterations = 50, Arb.list(Arb.int(300..600), 1..12)) { gaps ->
                val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
                hardware.rom.setSensorTypeAndMode(0, 1, SensorMode.EDGE.code)
                hardware.rom.setSensorTypeAndMode(1, 1, SensorMode.PULSE.code)
                for (port in 0..1) hardware.rom.setSensorValue(port, 0, SensorField.VALUE)
                hardware.tick(3)
                var pressed = false
                for (gap in gaps) {
                    pressed = !pressed
                    for (port in 0..1) hardware.sensors.measure(port, if (pressed) 100 else 1023)
                    hardware.tick(gap)
                }
                hardware.rom.readSensor(0, SensorRequest.CANONICAL) shouldBe gaps.size
                hardware.rom.readSensor(1, SensorRequest.CANONICAL) shouldBe (gaps.size + 1) / 2
            }
        }

        "a switch that bounces within the debounce counts once" {
            checkAll(iterations = 50, Arb.list(Arb.int(0..1023), 0..90)) { bounces ->
                val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
                hardware.rom.setSensorTypeAndMode(0, 1, SensorMode.EDGE.code)
                hardware.rom.setSensorValue(0, 0, SensorField.VALUE)
                hardware.tick(3)
                for (raw in listOf(100) + bounces + 100) {
                    hardware.sensors.measure(0, raw)
                    hardware.tick(3)
                }
                hardware.tick(400)
                hardware.rom.readSensor(0, SensorRequest.CANONICAL) shouldBe 1
            }
        }

        "the battery's raw value for any millivolts is the lowest that gives them" {
            checkAll(Exhaustive.ints(0..28_000)) { millivolts ->
                val raw = Battery.rawOf(millivolts)
                (Battery.millivolts(raw) >= millivolts) shouldBe true
                if (raw > 0) (Battery.millivolts(raw - 1) < millivolts) shouldBe true
            }
        }

        "the low byte of a duration is what a tone lasts" {
            checkAll(Exhaustive.ints(0..0xFFFF)) { duration ->
                val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))
                hardware.call(RomAddress.PLAY_TONE, RomCode.TONE, 440, duration)
                hardware.memory.readByte(Speaker.QUEUE_VALUES) shouldBe duration % 256
            }
        }
    })

private infix fun Double.shouldBeLess(limit: Double) {
    (this < limit) shouldBe true
}
