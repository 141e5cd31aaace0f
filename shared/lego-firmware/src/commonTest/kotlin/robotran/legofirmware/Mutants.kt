package robotran.legofirmware

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.language.source.Severity
import robotran.legofirmware.assembly.AssemblyLimits
import robotran.legofirmware.assembly.AssemblyResult
import robotran.legofirmware.assembly.assemble
import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.RcxImageResult
import robotran.legofirmware.image.readRcxImage
import robotran.legofirmware.image.toBytes
import robotran.legofirmware.listing.assemblyListing
import robotran.legofirmware.listing.plainListing
import robotran.legofirmware.run.FirmwareState
import robotran.rcxrom.RcxBrick
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.sensors.SensorCode
import kotlin.random.Random
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** Damages an image of the vectors and tries it. Returns whether it could be read. */
internal fun tryMutatedImage(random: Random): Boolean = tryImage(mutated(images.random(random), random))

/** Does with an image all that can be done. Returns whether it could be read. */
internal fun tryImage(bytes: ByteArray): Boolean {
    val read = readRcxImage(bytes) as? RcxImageResult.Success ?: return false
    checkForms(read.image, bytes.size)
    runOnBrick(read.image)
    return true
}

/** A program runs as long as it likes, and with every sensor pressed after a while; what it leaves behind is limited. */
private fun runOnBrick(image: RcxImage) {
    val brick =
        RcxBrick(
            listOf(FirmwareProgram("mutant", image, image.assemblyListing().lines, language = Language.ENGLISH)),
            messages = BrickMessages.of(Language.ENGLISH),
        )
    brick.press(BrickButton.RUN)
    brick.release(BrickButton.RUN)
    repeat(RUN_MILLISECONDS) { brick.tick() }
    for (port in 0 until SensorCode.PORTS) brick.setRawSensorValue(port, 0)
    repeat(RUN_MILLISECONDS) { brick.tick() }
    val instructions = 2 * RUN_MILLISECONDS / 2
    assertTrue(brick.log.total < CALLS_AT_START + instructions * CALLS_OF_INSTRUCTION, "${brick.log.total} calls")
    assertTrue(brick.warnings.size <= REMARKS)
    val state = brick.firmwareState as FirmwareState
    assertTrue(state.variables.all { it in Short.MIN_VALUE..Short.MAX_VALUE })
}

/** Texts have a few dozen characters a byte at most; assembling one gives the same program. */
private fun checkForms(image: RcxImage, bytes: Int) {
    assertTrue(image.plainListing().length < LISTING_CHARACTERS * (bytes + 1))
    val listing = image.assemblyListing()
    assertTrue(listing.text.length < LISTING_CHARACTERS * (bytes + 1))
    val result = assemble(listing.text, Language.ENGLISH)
    assertTrue(result is AssemblyResult.Success, listing.text)
    assertEquals(image.chunks.sortedBy { it.id }, result.image.chunks.sortedBy { it.id })
    assertEquals(image, (readRcxImage(image.toBytes()) as RcxImageResult.Success).image)
}

private fun mutated(original: ByteArray, random: Random): ByteArray {
    var bytes = original.copyOf()
    repeat(random.nextInt(1, MOST_MUTATIONS)) {
        val place = if (bytes.isEmpty()) 0 else random.nextInt(bytes.size)
        bytes = when (random.nextInt(MUTATIONS)) {
            0 -> bytes.copyOf(place)
            1 -> bytes.copyOfRange(0, place) + random.nextInt().toByte() + bytes.copyOfRange(place, bytes.size)
            2 -> bytes + random.nextBytes(random.nextInt(MOST_MUTATIONS))
            else -> bytes.also { if (it.isNotEmpty()) it[place] = random.nextInt().toByte() }
        }
    }
    return bytes
}

/** Damages an assembly text of the vectors and tries it. Returns whether it was right. */
internal fun tryMutatedText(random: Random): Boolean = tryText(mutated(texts.random(random), random))

/** Assembles [text]. Returns whether it was right. */
internal fun tryText(text: String): Boolean = when (val result = assemble(text, Language.ENGLISH)) {
    is AssemblyResult.Success -> {
        assertTrue(result.image.chunks.all { it.code.size <= FirmwareLimits.CHUNK_BYTES })
        assertTrue(result.image.codeSize <= text.length)
        assertTrue(readRcxImage(result.image.toBytes()) is RcxImageResult.Success)
        true
    }

    is AssemblyResult.Failure -> {
        assertTrue(result.diagnostics.size in 1..AssemblyLimits.DIAGNOSTICS)
        val lines = text.lines()
        for (found in result.diagnostics) {
            assertTrue(found.severity == Severity.ERROR && found.message.length < MESSAGE_CHARACTERS, found.message)
            val range = assertNotNull(found.range)
            assertEquals(found.text, lines[range.line - 1].substring(range.column - 1, range.endColumn - 1))
        }
        false
    }
}

private fun mutated(original: String, random: Random): String {
    val text = StringBuilder(original)
    repeat(random.nextInt(1, MOST_MUTATIONS)) {
        val place = random.nextInt(text.length + 1)
        val end = minOf(text.length, place + random.nextInt(MOST_MUTATIONS))
        when (random.nextInt(MUTATIONS)) {
            0 -> text.deleteRange(place, end)
            1 -> text.insert(place, text.substring(place, end))
            2 -> text.insert(place, PIECES.random(random))
            else -> text.insert(place, random.nextInt(' '.code, 0x180).toChar())
        }
    }
    return text.toString()
}

private val images by lazy { Vectors.names.map { Vectors.bytes(it) } }
private val texts by lazy { Vectors.names.mapNotNull { Vectors.text("$it.lasm") } }
private const val RUN_MILLISECONDS = 60
private const val CALLS_AT_START = 60
private const val CALLS_OF_INSTRUCTION = 4
private const val REMARKS = 100
private const val MOST_MUTATIONS = 6
private const val MUTATIONS = 6
private const val LISTING_CHARACTERS = 120
private const val MESSAGE_CHARACTERS = 400
private val PIECES = listOf(
    "\n",
    "\t",
    " ",
    ",",
    ":",
    ";",
    "-",
    "0x",
    "99999999999",
    "task",
    "endt",
    "sub",
    "ends",
    "\ttask\t1\n",
    "\tendt\n",
    "chk",
    "stop",
    "byte 1, 2",
    "t0000008",
    "\tjmp\tt0000000 \n",
    "; Var 0 = x\n",
    "65536",
    "-32769",
)
