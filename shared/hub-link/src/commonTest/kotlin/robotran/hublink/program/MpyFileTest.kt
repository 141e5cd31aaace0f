package robotran.hublink.program

import robotran.hublink.HubError
import robotran.hublink.bytesOf
import robotran.hublink.hexOf
import robotran.hublink.mpyOf
import robotran.hublink.vectorLines
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class MpyFileTest {
    @Test
    fun `the beginning of compiled files is read`() {
        for ((file, hex) in vectorLines("mpy.txt")) {
            val mpy = assertNotNull(MpyFile.read(bytesOf(hex)), file)
            assertEquals(file, mpy.fileName)
            assertEquals(31, mpy.smallIntegerBits)
            assertTrue(!mpy.nativeCode)
        }
    }

    @Test
    fun `whole numbers beyond 31 bits are found among the constants`() {
        assertEquals(listOf("1073741824"), MpyFile.read(mpyOf("numbers.py"))?.longNumbers)
        assertEquals(emptyList(), MpyFile.read(mpyOf("decimals.py"))?.longNumbers)
        // print(-1073741824, -1073741825, 1073741823)
        assertEquals(listOf("-1073741825"), MpyFile.read(bytesOf(MINUS))?.longNumbers)
        // a = (1, 2.5, "x", (3, 4000000000))
        assertEquals(listOf("4000000000"), MpyFile.read(bytesOf(TUPLE))?.longNumbers)
    }

    @Test
    fun `texts and bytes among the constants are passed over`() {
        assertEquals(emptyList(), MpyFile.read(bytesOf(BYTES))?.longNumbers)
        assertEquals(emptyList(), MpyFile.read(bytesOf(COMPLEX))?.longNumbers)
    }

    @Test
    fun `a program that no hub could run says why`() {
        assertEquals(HubError.NumberTooLarge("1073741824"), HubProgram(mpyOf("numbers.py")).mistake())
        assertNull(HubProgram(mpyOf("square.py")).mistake())
        for (rubbish in listOf("", "4d", "4d05001f", "50726f6772616d", "4d06001f")) {
            assertEquals(HubError.NotAProgram, HubProgram(bytesOf(rubbish.ifEmpty { "-" })).mistake(), rubbish)
        }
        val hello = mpyOf("hello.py")
        assertEquals(HubError.NotAProgram, HubProgram(hello.copyOf().also { it[3] = 63 }).mistake())
        assertEquals(HubError.NotAProgram, HubProgram(hello.copyOf().also { it[2] = 0x14 }).mistake())
    }

    @Test
    fun `containers are those that hubs load`() {
        for (line in vectorLines("containers.txt")) {
            val modules = line.dropLast(1).map { HubModule(it.substringBefore('='), mpyOf(it.substringAfter('='))) }
            assertEquals(line.last(), hexOf(HubProgram(modules).bytes))
        }
    }

    @Test
    fun `containers and single modules are read from files`() {
        for (line in vectorLines("containers.txt")) {
            assertEquals(line.last(), HubProgram.read(bytesOf(line.last()))?.let { hexOf(it.bytes) })
        }
        val hello = HubProgram.read(mpyOf("hello.py"))
        assertEquals(vectorLines("containers.txt").first().last(), hello?.let { hexOf(it.bytes) })
        val container = bytesOf(vectorLines("containers.txt").last().last())
        for (size in listOf(
            0,
            3,
            10,
            container.size - 1,
        )) {
            assertNull(HubProgram.read(container.copyOf(size)), "$size bytes")
        }
        assertNull(HubProgram.read("print(1)".encodeToByteArray()))
    }

    @Test
    fun `any bytes are read or refused`() {
        val random = Random(3)
        val good = vectorLines("mpy.txt").map { bytesOf(it[1]) }
        var refused = 0
        repeat(2_000) {
            val bytes = good.random(random).copyOf(random.nextInt(1, 200))
            repeat(random.nextInt(4)) { bytes[random.nextInt(bytes.size)] = random.nextInt().toByte() }
            if (MpyFile.read(bytes) == null) refused++
        }
        assertTrue(refused in 100..1_900, "$refused refused")
    }

    private companion object {
        const val MINUS = "4d06001f0302106d696e75732e7079000f8177070b2d31303733373431383234" +
            "070b2d3130373337343138323581201802011102230023012283ffffff7f3403595163"
        const val TUPLE = "4d06001f0401107475706c652e7079000f02610081770a040701310803322e35050178000a02070133070a" +
            "3430303030303030303081080804012423001602110311023401595163"
        const val BYTES =
            "4d06001f04011062797465732e7079000f0261008177061968656c6c6f20776f726c642074686973206973206279746573" +
                "0081080804012423001602110311023401595163"
        const val COMPLEX = "4d06001f03020c656c6c2e7079000f8177040902316a78180201110223005123013403595163"
    }
}
