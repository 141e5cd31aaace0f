package robotran.hublink

/**
 * What a connected hub is.
 *
 * @property name as somebody has named it, or "Pybricks Hub".
 * @property profile the version of the protocol.
 */
data class HubDescription(
    val name: String,
    val kind: HubKind,
    val firmware: HubVersion,
    val profile: HubVersion,
    val capabilities: HubCapabilities,
) {
    /** The longest program that it takes, in bytes. */
    val programRoom: Int get() = capabilities.roomFor(kind)

    /** Whether its firmware is newer than what we know. It will do, but nobody has tried it. */
    val isNewerThanKnown: Boolean
        get() = profile.major > Profile.NEWEST.major || profile.minor > Profile.NEWEST.minor
}
