package robotran.cli.console

import kotlinx.serialization.json.Json

/** How the command line writes JSON: for people to read as well. */
internal val jsonOutput = Json { prettyPrint = true }
