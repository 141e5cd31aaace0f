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

/**
 * Where [link], an address or a text with one such as the code for a frame, leads to if only this machine can follow it,
 * such as `localhost:8080`; null if others can, too, as far as the address tells.
 */
fun localSite(link: String): String? {
    val start = SCHEMES.firstNotNullOfOrNull { scheme ->
        link.indexOf(scheme, ignoreCase = true).takeIf { it >= 0 }?.let { it + scheme.length }
    } ?: return null
    val site = link.substring(start).takeWhile { it.isLetterOrDigit() || it in HOST_CHARACTERS }.lowercase()
    val host = if (site.startsWith('[')) site.substringBefore(']').drop(1) else site.substringBefore(':')
    val isLocal = host == LOCAL || host.endsWith(".$LOCAL") || host in OWN_NUMBERS || OWN_NETWORK.matches(host)
    return site.takeIf { isLocal }
}

private val SCHEMES = listOf("https://", "http://")

/**
 * Allows numeric hosts and ports. A user name and password before an `@` are rejected, because they can disguise the
 * host.
 */
private const val HOST_CHARACTERS = ".-:[]"
private const val LOCAL = "localhost"
private val OWN_NUMBERS = setOf("::1", "0.0.0.0", "::")
private val OWN_NETWORK = Regex("127(\\.\\d{1,3}){3}")
private const val NEVER = "<>\"\\^`{|}"
