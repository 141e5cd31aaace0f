package robotran.world.file

import kotlinx.serialization.json.Json
import robotran.json.schema.SchemaFile

/** The schema of world files, `worlds/world.schema.json`. */
internal val WorldSchema = SchemaFile(Json.parseToJsonElement(schemaTexts.getValue("world.schema.json")))
