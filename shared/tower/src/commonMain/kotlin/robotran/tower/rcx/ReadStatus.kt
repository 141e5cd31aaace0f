package robotran.tower.rcx

import robotran.tower.BrickStatus
import robotran.tower.Key
import robotran.tower.RcxOpcode
import robotran.tower.RcxVersion
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.Tries
import robotran.tower.line.Reply
import robotran.tower.line.Requests

/** Asks what the brick is, without changing anything on it. */
internal suspend fun readStatus(requests: Requests): TowerResult<BrickStatus> {
    requests.reach()?.let { return TowerResult.Failure(it) }
    val versions = when (val result = readVersions(requests)) {
        is TowerResult.Success -> result.value
        is TowerResult.Failure -> return if (result.error == TowerError.BrickSilent) UNKNOWN else result
    }
    if (!versions.hasFirmware) return TowerResult.Success(BrickStatus.LejosOrNoFirmware(versions.rom))
    val battery = requests.request(byteArrayOf(RcxOpcode.BATTERY.toByte()), BATTERY_BYTES)
    if (battery is Reply.Failure && battery.error == TowerError.TowerGone) return TowerResult.Failure(battery.error)
    val millivolts = (battery as? Reply.Success)?.let { lowFirst(it.payload) }
    return TowerResult.Success(BrickStatus.LegoFirmware(versions.rom, versions.firmware, millivolts))
}

/** The versions of ROM and firmware. */
internal class Versions(val rom: RcxVersion, val firmware: RcxVersion) {
    /** False for leJOS, too: it says the same as the ROM alone. */
    val hasFirmware get() = firmware != NO_VERSION
}

internal suspend fun readVersions(requests: Requests, tries: Int = Tries.REQUEST): TowerResult<Versions> {
    val message = byteArrayOf(RcxOpcode.VERSIONS.toByte()) + Key.PRIMES
    return when (val reply = requests.request(message, VERSIONS_BYTES, tries)) {
        is Reply.Failure -> TowerResult.Failure(reply.error)
        is Reply.Success -> TowerResult.Success(Versions(versionAt(reply.payload, 0), versionAt(reply.payload, 4)))
    }
}

/** The voltage of the batteries, in mV. Only LEGO's firmware tells it. */
internal suspend fun readBattery(requests: Requests): TowerResult<Int> =
    when (val reply = requests.request(byteArrayOf(RcxOpcode.BATTERY.toByte()), BATTERY_BYTES)) {
        is Reply.Failure -> TowerResult.Failure(reply.error)
        is Reply.Success -> TowerResult.Success(lowFirst(reply.payload))
    }

/** Whether a firmware runs after a firmware download, when there is no program yet that asking leJOS would delete. */
internal suspend fun Requests.firmwareRuns(): TowerResult<Boolean> {
    when (val versions = readVersions(this)) {
        is TowerResult.Success -> if (versions.value.hasFirmware) return TowerResult.Success(true)
        is TowerResult.Failure -> return if (versions.error == TowerError.BrickSilent) FALSE else versions
    }
    val begin = byteArrayOf(RcxOpcode.LEJOS_BEGIN.toByte()) + Key.LEJOS
    return when (val reply = request(begin, Key.LEJOS.size, Tries.LEJOS_BEGIN_WHEN_CLEAR)) {
        is Reply.Failure -> if (reply.error == TowerError.TowerGone) TowerResult.Failure(reply.error) else FALSE
        is Reply.Success -> TowerResult.Success(reply.payload.contentEquals(Key.LEJOS)).also { endBegun(it.value) }
    }
}

/** leJOS waits for a program now. The same message again makes it stop waiting, and it does not answer that. */
private suspend fun Requests.endBegun(hasBegun: Boolean) {
    if (hasBegun) line.sendOnly(byteArrayOf(RcxOpcode.LEJOS_BEGIN.toByte()) + Key.LEJOS)
}

/** Two bytes of the major version, two digits of the minor one: `00 03 03 02` is 3.32. */
private fun versionAt(payload: ByteArray, index: Int) =
    RcxVersion(number(payload[index + 1]), number(payload[index + 2]) * DIGITS + number(payload[index + 3]))

private fun number(byte: Byte) = byte.toInt() and 0xFF

private fun lowFirst(bytes: ByteArray): Int =
    (bytes[0].toInt() and 0xFF) or (bytes[1].toInt() and 0xFF shl Byte.SIZE_BITS)

private val NO_VERSION = RcxVersion(0, 0)
private val UNKNOWN = TowerResult.Success(BrickStatus.Unknown)
private val FALSE = TowerResult.Success(false)
private const val DIGITS = 10
private const val VERSIONS_BYTES = 8
private const val BATTERY_BYTES = 2
