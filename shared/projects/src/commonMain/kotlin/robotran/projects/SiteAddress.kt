package robotran.projects

/**
 * The address of a Robotran site in [text], to be put before the `#` of a link. Returns null if it is invalid: it must
 * begin with `https://` or `http://` and contain a host. Ignores everything from a `#` on, as in a pasted link, and
 * surrounding blanks.
 */
fun siteAddress(text: String): String? {
    val address = text.trim().substringBefore('#')
    val start = SCHEMES.firstOrNull { address.startsWith(it, ignoreCase = true) } ?: return null
    val machine = address.drop(start.length).takeWhile { it != '/' && it != '?' }
    val startsAsHost = machine.firstOrNull()?.let { it.isLetterOrDigit() || it == '[' } == true
    val isHost = startsAsHost && machine.all { it.isLetterOrDigit() || it in HOST_CHARACTERS }
    val isWhole = address.none { it.isWhitespace() || it.isISOControl() || it in NEVER }
    return address.takeIf { isHost && isWhole && it.length <= ProjectLimits.MAXIMUM_SITE_CHARACTERS }
}

private val SCHEMES = listOf("https://", "http://")

/**
 * Allows numeric hosts and ports. A user name and password before an `@` are rejected, because they can disguise the
 * host.
 */
private const val HOST_CHARACTERS = ".-:[]"
private const val NEVER = "<>\"\\^`{|}"
