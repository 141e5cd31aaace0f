package robotran.projects

/**
 * The address of a site of Robotran that is meant by [text], to be put before the `#` of a link; null if it is none: it
 * has to begin with `https://` or `http://` and to name a machine. What stands behind a `#` in it, as of a link that
 * was pasted, does not count, nor do blanks around it.
 */
fun siteAddress(text: String): String? {
    val address = text.trim().substringBefore('#')
    val start = SCHEMES.firstOrNull { address.startsWith(it, ignoreCase = true) } ?: return null
    val machine = address.drop(start.length).takeWhile { it != '/' && it != '?' }
    val beginsAsMachine = machine.firstOrNull()?.let { it.isLetterOrDigit() || it == '[' } == true
    val isMachine = beginsAsMachine && machine.all { it.isLetterOrDigit() || it in IN_MACHINE }
    val isWhole = address.none { it.isWhitespace() || it.isISOControl() || it in NEVER }
    return address.takeIf { isMachine && isWhole && it.length <= ProjectLimits.MAXIMUM_SITE_CHARACTERS }
}

private val SCHEMES = listOf("https://", "http://")

/**
 * Also of numbers with a port. Nobody needs a name and a password before an `@`, but they make one machine look like
 * another.
 */
private const val IN_MACHINE = ".-:[]"
private const val NEVER = "<>\"\\^`{|}"
