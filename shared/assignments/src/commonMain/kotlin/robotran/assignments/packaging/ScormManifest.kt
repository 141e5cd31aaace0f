package robotran.assignments.packaging

import robotran.projects.Project

/** The `imsmanifest.xml` of a package with [files], whose items are [assignments]. */
internal fun manifestOf(
    title: String,
    assignments: List<Project>,
    version: ScormVersion,
    files: List<String>,
): String {
    val words = if (version == ScormVersion.SCORM_1_2) WORDS_1_2 else WORDS_2004
    val identifier = "robotran-" + assignments.first().assignment?.id.orEmpty().filter { it.isLetterOrDigit() }
    val items = assignments.mapIndexed { number, project ->
        """
        |      <item identifier="item-$number" identifierref="robotran" parameters="?assignment=$number">
        |        <title>${escaped(project.world.title)}</title>
        |      </item>
        """.trimMargin()
    }
    return """
        |<?xml version="1.0" encoding="UTF-8"?>
        |<manifest identifier="$identifier" version="1" ${words.namespaces}>
        |  <metadata>
        |    <schema>ADL SCORM</schema>
        |    <schemaversion>${words.version}</schemaversion>
        |  </metadata>
        |  <organizations default="robotran-organization">
        |    <organization identifier="robotran-organization">
        |      <title>${escaped(title)}</title>
        |${items.joinToString("\n")}
        |    </organization>
        |  </organizations>
        |  <resources>
        |    <resource identifier="robotran" type="webcontent" ${words.type}="sco" href="$START_PAGE">
        |${files.joinToString("\n") { "      <file href=\"${escaped(it)}\"/>" }}
        |    </resource>
        |  </resources>
        |</manifest>
        |
        """.trimMargin()
}

private fun escaped(text: String): String =
    text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")

/** How the two versions call the same. */
private class ManifestWords(val version: String, val type: String, val namespaces: String)

private val WORDS_1_2 = ManifestWords(
    "1.2",
    "adlcp:scormtype",
    "xmlns=\"http://www.imsproject.org/xsd/imscp_rootv1p1p2\" xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_rootv1p2\"",
)

private val WORDS_2004 = ManifestWords(
    "2004 4th Edition",
    "adlcp:scormType",
    "xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" xmlns:adlcp=\"http://www.adlnet.org/xsd/adlcp_v1p3\"",
)
