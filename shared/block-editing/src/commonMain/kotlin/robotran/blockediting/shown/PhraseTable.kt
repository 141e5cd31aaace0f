package robotran.blockediting.shown

import robotran.language.Language

/**
 * Lines and values that blocks show in another order, or with other small words, than a program has them: a row for each
 * form, a column for each language. Other forms, and empty cells, are shown word for word.
 *
 * A figure stands for a part of the line or value, in the order of a program, from 1; all else are words. Every part that
 * a pupil can change is there once. The first column has an example, a part in each pair of brackets.
 */
private const val PHRASE_TABLE = """
form           | en: parts                            | es             | de                  | fr                | pt
TURN           | [turn][left][90]                     | 1 a la 2 3     | 1 nach 2 um 3       | 1 à 2 de 3        | 1 à 2 3
TURN_FOR_TIME  | [turn][left][for][1][second]         | 1 a la 2 3 4 5 | 1 nach 2 3 4 5      | 1 à 2 3 4 5       | 1 à 2 3 4 5
START_MOVING   | [start][forward]                     | 1 hacia 2      |                     | 1 en 2            | 1 para 2
START_TURNING  | [start][turning][left]               | 1 2 a la 3     | 1 2 nach 3          | 1 en 2 à 3        | 1 2 à 3
POWER_OF_SIDE  | [power][left][5]                     |                |                     | 1 à 2 3           | 1 à 2 3
PEN            | [pen][down]                          |                |                     | 1 en 2            | 1 para 2
WAIT_UNTIL     | [wait][until][light < 40]            |                |                     | 1 jusqu'à 3       |
REPEAT_UNTIL   | [repeat][until][light < 40]          |                |                     | 1 jusqu'à 3       |
REPEAT_WHILE   | [repeat][while][light < 40]          |                |                     | 1 tant que 3      |
REPEAT_FOREVER | [repeat][forever]                    | 1 para 2       |                     | 1 sans fin        | 1 para 2
LIGHT_SENSOR   | [light][sensor][on][2][facing][down] | 2 de 1 3 4 5 6 | lichtsensor 3 4 5 6 | 2 de 1 3 4 5 le 6 | 2 de 1 3 4 5 para 6
COLOUR_SENSOR  | [colour][sensor][on][3]              | 2 de 1 3 4     | farbsensor 3 4      | 2 de 1 3 4        | 2 de 1 3 4
SOUND_SENSOR   | [sound][sensor][on][2]               | 2 de 1 3 4     | geräuschsensor 3 4  | 2 de 1 3 4        | 2 de 1 3 4
BUMPER         | [left][bumper]                       | 2 1            |                     | 2 1               | 2 1
"""

/** The pieces of a phrase: a part of the line by its index from 0, or words. */
internal sealed interface PhrasePiece {
    data class Part(val index: Int) : PhrasePiece

    data class Words(val text: String) : PhrasePiece
}

/** The phrase of the line or value [form] in [language]; null if it is shown word for word. */
internal fun phraseOf(form: Enum<*>, language: Language): List<PhrasePiece>? = PHRASES[form.name to language.tag]

private val PHRASES: Map<Pair<String, String>, List<PhrasePiece>> by lazy {
    val rows = PHRASE_TABLE.trim().lines().map { row -> row.split('|').map { it.trim() } }
    buildMap {
        for (row in rows.drop(1)) {
            for (column in FIRST_LANGUAGE..row.lastIndex) {
                if (row[column].isNotEmpty()) put(row.first() to rows.first()[column], pieces(row[column]))
            }
        }
    }
}

private fun pieces(cell: String): List<PhrasePiece> = buildList {
    for (word in cell.split(' ').filter { it.isNotEmpty() }) {
        val last = lastOrNull()
        when {
            word.first().isDigit() -> add(PhrasePiece.Part(word.toInt() - 1))
            last is PhrasePiece.Words -> set(lastIndex, PhrasePiece.Words("${last.text} $word"))
            else -> add(PhrasePiece.Words(word))
        }
    }
}

private const val FIRST_LANGUAGE = 2
