package robotran.rcxrom

import robotran.brick.log.CallOutcome
import robotran.brick.sound.SoundEvent
import robotran.brick.sound.SoundTrack
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class SoundRoutineTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    @Test
    fun `system sounds have the pitches and lengths of the ROM`() {
        val melody = listOf(1397, 1302, 1202, 1101, 1000, 899, 801, 698, 601, 500)
        val sounds = mapOf(
            0 to listOf(2000 to 10),
            1 to listOf(1000 to 150, 1000 to 150),
            2 to melody.map { it to 60 },
            3 to melody.reversed().map { it to 60 },
            4 to listOf(100 to 1000),
            5 to melody.reversed().map { it to 30 },
            6 to listOf(100 to 1000),
            -1 to listOf(100 to 1000),
        )
        for ((number, tones) in sounds) {
            val fresh = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            fresh.call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, number)
            fresh.tick(2_000)
            val events = fresh.tones()
            assertEquals(tones.map { it.second }, events.map { it.durationMilliseconds }, "lengths of $number")
            tones.zip(events).forEach { (tone, event) ->
                assertTrue(abs(tone.first - event.hertz) < 1.0, "sound $number is ${event.hertz}")
            }
        }
    }

    @Test
    fun `the tones of a sound follow one another in virtual time`() {
        hardware.call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, 1)
        hardware.tick(1_000)
        assertEquals(listOf(10L, 210L), hardware.tones().map { it.milliseconds })
    }

    @Test
    fun `a tone is heard for its duration and then no more`() {
        hardware.tone(440, 20)
        val heard = (1..300).filter {
            hardware.tick()
            hardware.speaker.sounding
        }
        assertEquals((10..209).toList(), heard)
    }

    @Test
    fun `the duration of a tone is a byte of hundredths of a second`() {
        val durations = mapOf(1 to 10, 255 to 2550, 257 to 10, 300 to 440, -1 to 2550)
        for ((given, milliseconds) in durations) {
            val fresh = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            assertEquals("queue tone of 440 Hz for $milliseconds ms", fresh.tone(440, given).meaning)
            fresh.tick(10)
            assertEquals(milliseconds, fresh.tones().single().durationMilliseconds)
        }
    }

    @Test
    fun `a tone of no duration is not heard and does not stop the queue`() {
        hardware.tone(440, 256)
        hardware.tone(880, 1)
        hardware.tick(30)
        assertEquals(listOf(20L), hardware.tones().map { it.milliseconds })
    }

    @Test
    fun `frequencies are rounded as the timer must`() {
        val real = mapOf(
            31 to 31.0020,
            122 to 122.0703,
            123 to 123.0315,
            440 to 440.1408,
            1000 to 1000.0,
            3921 to 3968.2540,
            20_000 to 20_000.0,
        )
        for ((asked, given) in real) {
            val hertz = realHertz(asked)
            assertTrue(hertz != null && abs(given - hertz) < 0.001, "$asked became $hertz")
        }
    }

    @Test
    fun `a frequency out of range is a silent pause`() {
        for (hertz in listOf(0, 30, 20_001, 65_535)) {
            val fresh = Hardware(messages = BrickMessages.of(Language.ENGLISH))
            assertEquals("queue pause of 100 ms", fresh.tone(hertz, 10).meaning)
            fresh.tone(440, 1)
            fresh.tick(200)
            assertEquals(listOf(110L), fresh.tones().map { it.milliseconds })
        }
    }

    @Test
    fun `nine sounds can wait and a tenth is dropped and reported`() {
        repeat(9) { assertEquals("queue system sound 0 (beep)", hardware.systemSound(0).meaning) }
        assertEquals("drop system sound 0 (beep), for the sound queue is full", hardware.systemSound(0).meaning)
        assertEquals(CallOutcome.DONE, hardware.systemSound(0).outcome)
        hardware.tick(1_000)
        assertEquals(9, hardware.tones().size)
    }

    @Test
    fun `a place is free again once the first sound is being played`() {
        repeat(9) { hardware.tone(440, 10) }
        hardware.tick(10)
        assertEquals("queue tone of 500 Hz for 100 ms", hardware.tone(500, 10).meaning)
    }

    @Test
    fun `an unqueued sound cuts the one that is played and forgets those that wait`() {
        hardware.tone(440, 200)
        hardware.tone(500, 200)
        hardware.tick(50)
        assertEquals(
            "50 0x299a 0x4003 0 ; play system sound 0 (beep) at once ; 7",
            hardware.call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_NOW, 0).text,
        )
        assertFalse(hardware.speaker.sounding)
        hardware.tick(5_000)
        assertEquals(listOf(10L, 60L), hardware.tones().map { it.milliseconds })
        assertEquals(listOf(SoundEvent.Cut(50)), hardware.speaker.track.since(0).filterIsInstance<SoundEvent.Cut>())
    }

    @Test
    fun `the tone routine plays system sounds too`() {
        assertEquals(
            "0 0x327c 0x1772 0 7 ; queue system sound 4 (buzz, for there is no 7) ; 7",
            hardware.call(RomAddress.PLAY_TONE, RomCode.TONE_SYSTEM_SOUND, 0, 7).text,
        )
        assertEquals(1, hardware.speaker.waitingCount)
    }

    @Test
    fun `the playing flag is set while sounds are played or wait`() {
        assertEquals("no sound is playing", readFlag().meaning)
        assertEquals(0, hardware.memory.readByte(RESULT))
        hardware.tone(440, 2)
        assertEquals("a sound is playing", readFlag().meaning)
        assertEquals(1, hardware.memory.readByte(RESULT))
        hardware.tick(29)
        assertEquals(1, hardware.memory.readByte(0xEFFF))
        hardware.tick()
        assertEquals(0, hardware.memory.readByte(0xEFFF))
    }

    @Test
    fun `sound codes that are not known are reported and play nothing`() {
        assertEquals(CallOutcome.WRONG_ARGUMENTS, hardware.call(RomAddress.PLAY_SYSTEM_SOUND, 0x4002, 0).outcome)
        assertEquals(CallOutcome.WRONG_ARGUMENTS, hardware.call(RomAddress.PLAY_TONE, 0x1774, 440, 10).outcome)
        assertEquals(0, hardware.speaker.waitingCount)
    }

    @Test
    fun `players listen each for itself and may come late`() {
        hardware.call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, 1)
        hardware.tick(100)
        val track = hardware.speaker.track
        val first = track.since(0)
        val heard = track.total
        hardware.tick(1_000)
        assertEquals(1, first.size)
        assertEquals(listOf(210L), track.since(heard).map { it.milliseconds })
        assertEquals(listOf(10L, 210L), track.since(0).map { it.milliseconds })
        assertEquals(emptyList(), track.since(track.total))
        assertEquals(emptyList(), track.since(track.total + 5))
    }

    @Test
    fun `sounds nobody listens to do not pile up without end`() {
        repeat(3_000) {
            hardware.tone(440, 1)
            hardware.tick(10)
        }
        val track = hardware.speaker.track
        assertEquals(3_000L, track.total)
        assertEquals(SoundTrack.CAPACITY, track.since(0).size)
        assertEquals(30_000L, track.since(0).last().milliseconds)
    }

    @Test
    fun `the queue is a ring in memory that a program can spoil but not break`() {
        hardware.tone(440, 10)
        assertEquals(listOf(71, 10, 7), listOf(0xEFD8, 0xEFE2, 0xEFEC).map(hardware.memory::readByte))
        for (address in 0xEFD6..0xEFFF) hardware.memory.writeByte(address, 0xFF)
        hardware.tick(10_000)
        hardware.tone(440, 10)
        hardware.tick(20)
        assertTrue(hardware.speaker.sounding)
    }

    private fun readFlag() = hardware.call(RomAddress.READ_SOUND_PLAYING, 0x700C, RESULT)

    private fun Hardware.tone(hertz: Int, hundredths: Int) = call(RomAddress.PLAY_TONE, RomCode.TONE, hertz, hundredths)

    private fun Hardware.systemSound(number: Int) = call(RomAddress.PLAY_SYSTEM_SOUND, RomCode.SOUND_QUEUED, number)
}
