package robotran.nqc.edit

import robotran.language.Language
import robotran.language.choose
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.api.NqcApi

/**
 * One sentence about [word]: a word of the language, or a name of the API for [target]. Null if there is none.
 *
 * @param isOld whether the API is that of NQC 1.3.
 */
fun nqcHelp(
    word: String,
    language: Language,
    target: FirmwareTarget = FirmwareTarget.RCX2,
    isOld: Boolean = false,
): String? = NqcApi.of(target, isOld)[word]?.help(language) ?: WORDS[word]?.of(language)

/** The words of the language that have help, by name. */
val nqcHelpWords: List<String> get() = WORDS.keys.toList()

private class WordHelp(private val english: String, private val german: String, private val spanish: String) {
    fun of(language: Language) = language.choose(english, spanish, german)
}

private val WORDS = mapOf(
    "abs" to WordHelp(
        "abs(x) is x without its minus.",
        "abs(x) ist x ohne Minus.",
        "abs(x) es x sin su menos.",
    ),
    "acquire" to WordHelp(
        "Asks for motors or sounds, so that a less important task cannot use them meanwhile.",
        "Bittet um Motoren oder Klänge, damit ein weniger wichtiger Task sie solange nicht benutzt.",
        "Pide motores o sonidos, para que una tarea menos importante no los use mientras.",
    ),
    "asm" to WordHelp(
        "Puts bytes into the program as they are.",
        "Setzt Bytes so in das Programm, wie sie sind.",
        "Pone bytes en el programa tal como son.",
    ),
    "break" to WordHelp(
        "Leaves a loop or a switch.",
        "Verlässt eine Schleife oder ein switch.",
        "Sale de un bucle o de un switch.",
    ),
    "case" to WordHelp(
        "Begins what switch does for a value.",
        "Beginnt, was switch für einen Wert tut.",
        "Empieza lo que switch hace con un valor.",
    ),
    "catch" to WordHelp(
        "Says what happens when an event comes, or when a more important task takes over.",
        "Sagt, was geschieht, wenn ein Ereignis kommt oder ein wichtigerer Task übernimmt.",
        "Dice qué pasa cuando llega un evento o cuando una tarea más importante toma el control.",
    ),
    "const" to WordHelp(
        "A parameter that the function cannot change.",
        "Ein Parameter, den die Funktion nicht ändern kann.",
        "Un parámetro que la función no puede cambiar.",
    ),
    "continue" to WordHelp(
        "Goes on with the next round of a loop.",
        "Macht mit der nächsten Runde einer Schleife weiter.",
        "Sigue con la próxima vuelta de un bucle.",
    ),
    "default" to WordHelp(
        "Begins what switch does for all other values.",
        "Beginnt, was switch für alle anderen Werte tut.",
        "Empieza lo que switch hace con todos los demás valores.",
    ),
    "do" to WordHelp(
        "Repeats a block while a condition is true, at least once.",
        "Wiederholt einen Block, solange eine Bedingung wahr ist, mindestens einmal.",
        "Repite un bloque mientras una condición sea cierta, al menos una vez.",
    ),
    "else" to WordHelp(
        "What happens if the condition of if is false.",
        "Was geschieht, wenn die Bedingung von if falsch ist.",
        "Lo que pasa si la condición de if es falsa.",
    ),
    "false" to WordHelp("The same as 0.", "Dasselbe wie 0.", "Lo mismo que 0."),
    "for" to WordHelp(
        "Repeats a block: for (first; condition; after each round).",
        "Wiederholt einen Block: for (zuerst; Bedingung; nach jeder Runde).",
        "Repite un bloque: for (primero; condición; tras cada vuelta).",
    ),
    "goto" to WordHelp(
        "Goes on at a label.",
        "Macht bei einer Marke weiter.",
        "Sigue en una etiqueta.",
    ),
    "if" to WordHelp(
        "Does something only if a condition is true.",
        "Tut etwas nur, wenn eine Bedingung wahr ist.",
        "Hace algo solo si una condición es cierta.",
    ),
    "int" to WordHelp(
        "Declares variables for whole numbers from -32768 to 32767.",
        "Legt Variablen für ganze Zahlen von -32768 bis 32767 an.",
        "Declara variables para números enteros de -32768 a 32767.",
    ),
    "monitor" to WordHelp(
        "Runs a block until one of its events comes.",
        "Führt einen Block aus, bis eines seiner Ereignisse kommt.",
        "Ejecuta un bloque hasta que llega uno de sus eventos.",
    ),
    "repeat" to WordHelp(
        "Repeats a block so many times.",
        "Wiederholt einen Block so oft.",
        "Repite un bloque tantas veces.",
    ),
    "return" to WordHelp(
        "Ends the function, sub or task.",
        "Beendet die Funktion, das Unterprogramm oder den Task.",
        "Termina la función, la subrutina o la tarea.",
    ),
    "sign" to WordHelp(
        "sign(x) is -1, 0 or 1, as x is negative, zero or positive.",
        "sign(x) ist -1, 0 oder 1, je nachdem ob x negativ, null oder positiv ist.",
        "sign(x) es -1, 0 o 1, según x sea negativo, cero o positivo.",
    ),
    "start" to WordHelp(
        "Starts a task, or begins it anew.",
        "Startet einen Task oder beginnt ihn neu.",
        "Inicia una tarea o la empieza de nuevo.",
    ),
    "stop" to WordHelp("Stops a task.", "Hält einen Task an.", "Para una tarea."),
    "sub" to WordHelp(
        "A piece of program with a name that is in the brick only once.",
        "Ein Programmstück mit Namen, das nur einmal im Stein ist.",
        "Un trozo de programa con nombre que está solo una vez en el ladrillo.",
    ),
    "switch" to WordHelp(
        "Does one of several things, depending on a value.",
        "Tut je nach Wert eines von mehreren Dingen.",
        "Hace una de varias cosas, según un valor.",
    ),
    "task" to WordHelp(
        "A part of the program that runs at the same time as others; main begins.",
        "Ein Teil des Programms, der gleichzeitig mit anderen läuft; main beginnt.",
        "Una parte del programa que funciona a la vez que otras; main empieza.",
    ),
    "true" to WordHelp("The same as 1.", "Dasselbe wie 1.", "Lo mismo que 1."),
    "void" to WordHelp(
        "Begins a function: a piece of program with a name and parameters.",
        "Beginnt eine Funktion: ein Programmstück mit Namen und Parametern.",
        "Empieza una función: un trozo de programa con nombre y parámetros.",
    ),
    "while" to WordHelp(
        "Repeats a block while a condition is true.",
        "Wiederholt einen Block, solange eine Bedingung wahr ist.",
        "Repite un bloque mientras una condición sea cierta.",
    ),
)
