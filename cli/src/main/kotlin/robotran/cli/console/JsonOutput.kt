package robotran.cli.console

import kotlinx.serialization.json.Json

/** The JSON format of the command line, indented for readability. */
internal val jsonOutput = Json { prettyPrint = true }
