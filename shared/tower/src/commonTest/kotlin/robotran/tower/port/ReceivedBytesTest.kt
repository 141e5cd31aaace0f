package robotran.tower.port

import kotlinx.coroutines.launch
import kotlinx.coroutines.test.runCurrent
import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertNull

class ReceivedBytesTest {
    private val received = ReceivedBytes()

    @Test
    fun `all that has come is taken at once and in order`() = runTest {
        received.add(byteArrayOf(1, 2))
        received.add(byteArrayOf())
        received.add(byteArrayOf(3))
        assertContentEquals(byteArrayOf(1, 2, 3), received.take())
    }

    @Test
    fun `whoever waits gets the next bytes`() = runTest {
        var taken: ByteArray? = null
        backgroundScope.launch { taken = received.take() }
        runCurrent()
        assertNull(taken)
        received.add(byteArrayOf(4))
        runCurrent()
        assertContentEquals(byteArrayOf(4), taken)
    }

    @Test
    fun `a wait that is cancelled loses nothing`() = runTest {
        val waiting = backgroundScope.launch { received.take() }
        runCurrent()
        received.add(byteArrayOf(5))
        waiting.cancel()
        runCurrent()
        assertContentEquals(byteArrayOf(5), received.take())
    }

    @Test
    fun `what came before the end is still taken`() = runTest {
        received.add(byteArrayOf(6))
        received.end()
        assertContentEquals(byteArrayOf(6), received.take())
        assertNull(received.take())
    }
}
