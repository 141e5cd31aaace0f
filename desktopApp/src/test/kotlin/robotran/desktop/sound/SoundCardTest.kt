package robotran.desktop.sound

import java.lang.reflect.Proxy
import javax.sound.sampled.LineUnavailableException
import javax.sound.sampled.SourceDataLine
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class SoundCardTest {
    private val asked = mutableListOf<String>()
    private var written = byteArrayOf()

    /** A line that records its calls and accepts all data. */
    private val line = Proxy.newProxyInstance(javaClass.classLoader, arrayOf(SourceDataLine::class.java)) {
        _,
        method,
        arguments,
        ->
        asked += method.name
        if (method.name == "write") {
            written += (arguments[0] as ByteArray).copyOf(arguments[2] as Int)
            arguments[2]
        } else {
            if (method.name == "open") assertEquals(FORMAT, arguments[0])
            null
        }
    } as SourceDataLine

    @Test
    fun `a line is opened and started, and given back`() {
        val opened = assertNotNull(openSoundCard { line })
        assertEquals(listOf("open", "start"), asked)
        opened.discard()
        opened.close()
        assertEquals(listOf("flush", "close"), asked.drop(2))
    }

    @Test
    fun `samples reach it as they are`() {
        assertNotNull(openSoundCard { line }).write(byteArrayOf(1, 0, -2, -1))
        assertContentEquals(byteArrayOf(1, 0, -2, -1), written)
    }

    @Test
    fun `a computer without a sound card, or with one that is taken, has no line`() {
        assertNull(openSoundCard { throw IllegalArgumentException("No line matching interface SourceDataLine") })
        assertNull(openSoundCard { throw LineUnavailableException("taken") })
        assertNull(openSoundCard { throw SecurityException() })
    }

    @Test
    fun `the format is sixteen bits for each of two ears, the low byte first`() {
        assertEquals(16, FORMAT.sampleSizeInBits)
        assertEquals(2, FORMAT.channels)
        assertTrue(!FORMAT.isBigEndian)
    }
}
