package robotran.blockediting.messages

import robotran.blockediting.BlockDeed
import robotran.blockediting.BlockEditError
import robotran.language.listed
import robotran.language.quoted
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.ValueKind

/** The messages in Spanish. They address the pupil as "tú". */
object SpanishBlockMessages : BlockMessages {
    override fun group(group: BlockGroup) = when (group) {
        BlockGroup.DRIVE -> "Conducir"
        BlockGroup.PEN -> "Lápiz"
        BlockGroup.SENSE -> "Sentir"
        BlockGroup.CONTROL -> "Control"
        BlockGroup.NUMBERS -> "Números"
        BlockGroup.LISTS -> "Listas"
        BlockGroup.OWN_COMMANDS -> "Órdenes propias"
        BlockGroup.SHOW_AND_SOUND -> "Pantalla y sonido"
    }

    override fun editError(error: BlockEditError) = when (error) {
        BlockEditError.NotFound -> "Este bloque ya no está. Inténtalo otra vez."
        BlockEditError.IntoItself -> "Un bloque no cabe dentro de sí mismo. Ponlo en otro sitio."
        BlockEditError.OnlyOutermost -> "Este bloque no puede estar dentro de otro. Ponlo encima o debajo de los demás."
        BlockEditError.SettingOutsideRobot -> "Este bloque va dentro de un bloque \"robot\". Ponlo ahí."

        BlockEditError.OnlySettings -> {
            "En un bloque \"robot\" solo hay líneas sobre el ladrillo y sus sensores. Pon el bloque debajo."
        }

        BlockEditError.SecondRobot -> "El programa ya tiene un bloque \"robot\". Cambia ese."
        BlockEditError.TooDeep -> "Habría demasiados bloques uno dentro de otro. Haz con algunos una orden propia."
        BlockEditError.TooLong -> "El programa sería demasiado largo. Borra algo antes."

        BlockEditError.LooseEnd -> {
            "Hay un \"end\" o un \"else\" que no es de ningún bloque. Bórralo o corrígelo e inténtalo otra vez."
        }

        BlockEditError.NoSuchConstruct -> "Esto solo va con un bloque que tiene otros dentro. Elige otro."
        BlockEditError.ElseExists -> "Este \"if\" ya tiene un \"else\". Pon ahí tus bloques."

        is BlockEditError.NoValue -> {
            error.mistake?.message ?: "${quoted(error.text)} no es un valor. Escribe un número, como \"20\"."
        }

        BlockEditError.NumberNeeded -> "Aquí va un número, como \"20\" o \"light\"."
        BlockEditError.ConditionNeeded -> "Aquí va una condición, como \"left bumper\" o \"light < 40\"."
        BlockEditError.ListNeeded -> "Aquí va una lista, como \"[1, 2, 3]\"."
        BlockEditError.LastItem -> "Una lista tiene al menos un número. Cámbialo o borra el bloque entero."
        BlockEditError.NoSuchForm -> "Este bloque no puede convertirse en ese. Toma un bloque nuevo de la paleta."
        is BlockEditError.NoChoice -> "Elige ${listed(error.options.map(::quoted), "o")}."

        is BlockEditError.NoName -> {
            "${quoted(
                error.name,
            )} no puede ser un nombre. Usa letras y cifras, primero una letra, y ninguna palabra de Robolang."
        }

        is BlockEditError.NameTaken -> "Otra cosa ya se llama ${quoted(error.name)}. Elige otro nombre."
        BlockEditError.NoText -> "Un texto es una línea sin comillas. Quítalas."
        BlockEditError.NoFix -> "Aquí no hay nada que se corrija solo. Cambia tú la línea."
        BlockEditError.NoNote -> "Corrige la línea antes de escribirle una nota."
        BlockEditError.NothingToInsert -> "No hay nada que pegar. Copia antes un bloque."

        BlockEditError.NoPlaceForValue -> {
            "Esto es un valor. Toca antes el lugar de un bloque donde va y luego tómalo otra vez, o arrástralo hasta allí."
        }

        BlockEditError.NothingToTry -> "Solo, este bloque no hace nada. Elige uno que haga algo, como \"forward 20\"."

        is BlockEditError.ValueUnknown -> {
            "${quoted(error.name)} solo tiene un valor en el programa entero. Pulsa Ejecutar o pon un número."
        }

        is BlockEditError.Mistaken -> "Línea ${error.line}: ${error.message}"
    }

    override fun level(level: Int) = "nivel $level"

    override fun inside(count: Int) = when (count) {
        0 -> "nada dentro"
        1 -> "1 bloque dentro"
        else -> "$count bloques dentro"
    }

    override fun isIn(line: String) = "en $line"

    override fun position(position: Int, count: Int) = "$position de $count"

    override fun blocks(count: Int) = if (count == 1) "1 bloque" else "$count bloques"

    override fun deed(deed: BlockDeed, what: String) = when (deed) {
        BlockDeed.ADDED -> "Añadido: $what"
        BlockDeed.MOVED -> "Movido: $what"
        BlockDeed.DOUBLED -> "Duplicado: $what"
        BlockDeed.DELETED -> "Borrado: $what"
        BlockDeed.CHANGED -> "Ahora: $what"
    }

    override fun gone(what: String) = "Quitado: $what"

    override fun undone(change: String?) = listOfNotNull("Deshecho.", change).joinToString(" ")

    override fun redone(change: String?) = listOfNotNull("Rehecho.", change).joinToString(" ")

    override fun note(text: String) = "nota: $text"

    override fun emptyLine() = "línea vacía"

    override fun mistake(line: String, message: String?) =
        "línea con un error: $line." + message?.let { " $it" }.orEmpty()

    override fun kind(kind: ValueKind) = when (kind) {
        ValueKind.NUMBER -> "número"
        ValueKind.CONDITION -> "condición"
        ValueKind.LIST -> "lista"
        ValueKind.COLOUR -> "color"
        ValueKind.UNKNOWN -> "valor"
    }

    override fun choice(options: List<String>) = "elige ${listed(options, "o")}"
}
