package robotran.hublink.hub

import robotran.hublink.HubCapabilities
import robotran.hublink.HubDescription
import robotran.hublink.HubError
import robotran.hublink.HubKind
import robotran.hublink.HubResult
import robotran.hublink.HubVersion
import robotran.hublink.Profile
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubValue

/** Asks a hub that was just connected what it is, and for its events. */
internal suspend fun meetHub(connection: HubConnection, line: HubLine): HubResult<HubDescription> {
    val firmware = connection.version(HubValue.FIRMWARE)
    val profile = connection.version(HubValue.PROFILE)
    if (line.state.value.isGone) return failed(HubError.OutOfReach)
    if (profile == null) {
        return failed(if (connection.isSureOfPybricks) HubError.TooOld(firmware) else HubError.LegoFirmware)
    }
    if (profile < Profile.OLDEST) return failed(HubError.TooOld(firmware))
    val capabilities = connection.read(HubValue.CAPABILITIES)?.let(HubCapabilities::read)
    if (line.state.value.isGone) return failed(HubError.OutOfReach)
    if (capabilities == null || !capabilities.takesPrograms) return failed(HubError.TooOld(firmware))
    val kind = connection.read(HubValue.PNP_ID)?.let(HubKind::ofPnpId) ?: HubKind.UNKNOWN
    val name = connection.read(HubValue.NAME)?.decodeToString()?.filterNot { it.isISOControl() }?.take(LONGEST_NAME)
    subscribe(connection, line)?.let { return failed(it) }
    val description = HubDescription(name.orEmpty(), kind, firmware ?: UNKNOWN_FIRMWARE, profile, capabilities)
    return HubResult.Success(description)
}

/** Asks for events; the error if none comes. Without its status a hub might run a program that we do not know of. */
private suspend fun subscribe(connection: HubConnection, line: HubLine): HubError? {
    repeat(SUBSCRIPTIONS) {
        val isAsked = connection.subscribe()
        if (!isAsked || line.state.value.isGone) return HubError.OutOfReach
        if (line.await(HubTimes.FIRST_STATUS) { it.status != null }) return null
    }
    return if (line.state.value.isGone) HubError.OutOfReach else HubError.BadConnection
}

private suspend fun HubConnection.version(value: HubValue): HubVersion? =
    read(value)?.decodeToString()?.let(HubVersion::read)

private fun failed(error: HubError) = HubResult.Failure(error)

private const val SUBSCRIPTIONS = 3
private val UNKNOWN_FIRMWARE = HubVersion(0, 0)

/** Pybricks itself has at most 15 bytes. */
private const val LONGEST_NAME = 40
