package robotran.assignments.reporting

import robotran.language.visibleText

/** Writes HTML in which every text is escaped. */
internal class HtmlWriter {
    private val html = StringBuilder()
    val text: String get() = html.toString()

    /** Adds [markup] as it is. */
    fun raw(markup: String) {
        html.append(markup)
    }

    fun text(words: String) = visibleText(words).forEach { letter ->
        when {
            letter == '&' -> html.append("&amp;")
            letter == '<' -> html.append("&lt;")
            letter == '>' -> html.append("&gt;")
            letter == '"' -> html.append("&quot;")
            letter == '\'' -> html.append("&#39;")
            else -> html.append(letter)
        }
    }

    /** The same, where what is between backticks in a line is program text. */
    fun marked(words: String) {
        var place = 0
        for (code in CODE.findAll(words)) {
            text(words.substring(place, code.range.first))
            raw("<code>")
            text(code.groupValues[1])
            raw("</code>")
            place = code.range.last + 1
        }
        text(words.substring(place))
    }

    /** @param words as [marked]. */
    fun element(name: String, words: String, style: String? = null) {
        raw(if (style == null) "<$name>" else "<$name class=\"$style\">")
        if (name in PLAIN) text(words) else marked(words)
        raw("</$name>")
    }

    fun list(items: List<String>) {
        raw("<ul>")
        items.forEach { element("li", it) }
        raw("</ul>\n")
    }

    private companion object {
        val CODE = Regex("`([^`\n]+)`")

        /** Elements in which no other may be, or which are program text as a whole. */
        val PLAIN = setOf("title", "pre")
    }
}

/** For the screen and for A4 paper, where a hand-in begins on a page of its own only if it does not fit. */
internal val REPORT_STYLE = """
    body { font: 15px/1.4 system-ui, sans-serif; color: #222; background: #fff; margin: 2em auto; max-width: 60em }
    body { padding: 0 1em }
    h1 { font-size: 1.6em } h2 { font-size: 1.25em; margin: 0 0 .3em } h3 { font-size: 1em; margin: .8em 0 .2em }
    table { border-collapse: collapse; width: 100%; margin: .6em 0 }
    th, td { border-bottom: 1px solid #ccc; padding: .25em .5em; text-align: left; vertical-align: top }
    th { background: #f2f2f2 } caption { text-align: left; font-weight: 600; padding: .2em 0 }
    table.all { font-size: .9em } table.all td, table.all th { padding: .25em .35em }
    table.all th { font-size: .8em }
    h1, h2, caption { overflow-wrap: anywhere; hyphens: auto }
    table.all td:not(.words), table.all th:not(.words) { width: 1% }
    table.all td:not([class]) { white-space: nowrap } table.all .words { min-width: 7em }
    .words { overflow-wrap: anywhere }
    .passed { color: #14632a; font-weight: 600 } .partly { color: #7a4d00; font-weight: 600 }
    .missed, .mistakes, .failed, .unusable { color: #9c1c1c; font-weight: 600 }
    section { border-top: 2px solid #888; padding-top: .8em; margin-top: 1.6em; overflow: hidden }
    img { float: right; width: 45%; max-height: 18em; object-fit: contain; margin: 0 0 .6em 1em }
    img { border: 1px solid #ccc }
    table.goals { width: auto; min-width: 50%; font-size: .9em } table.goals th { overflow-wrap: normal }
    section p { margin: .3em 0 }
    pre { font: 13px/1.35 ui-monospace, monospace; background: #f6f6f6; padding: .6em; margin: .2em 0 }
    pre { white-space: pre-wrap; overflow-wrap: anywhere; clear: both; tab-size: 4 }
    .file { font-weight: 600; margin: .4em 0 0 } .comment { white-space: pre-wrap }
    @page { size: A4; margin: 15mm }
    @media print {
      body { font-size: 10pt; margin: 0; max-width: none; padding: 0 } a { color: inherit; text-decoration: none }
      section { break-inside: avoid } thead { display: table-header-group } tr, img, h2, h3 { break-inside: avoid }
      h2, h3, caption { break-after: avoid } pre { font-size: 8.5pt }
    }
""".trimIndent()
