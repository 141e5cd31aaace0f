package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.MESSAGE
import robotran.nqc.config.ParameterLimit.PRIORITY
import robotran.nqc.config.ParameterLimit.PROGRAM

internal val MESSAGE_API = api(NqcApiGroup.MESSAGES) {
    function(
        "SendMessage(const int &message)",
        "asm { 0xb2, \$message : 0x1000000 + {basic} };",
        ApiHelp(
            "Sends a number from 1 to 255 to other bricks by infrared light.",
            "Schickt anderen Steinen eine Zahl von 1 bis 255 über Infrarotlicht.",
            "Envía a otros ladrillos un número de 1 a 255 por infrarrojos.",
        ),
        MESSAGE,
    )
    function(
        "ClearMessage()",
        "asm { 0x90 };",
        ApiHelp("Forgets the last message.", "Vergisst die letzte Nachricht.", "Olvida el último mensaje."),
    )
    function(
        "SetMessage(const int message)",
        "asm { 0xf7, message };",
        ApiHelp(
            "Sets the message as if another brick had sent it.",
            "Setzt die Nachricht, als hätte ein anderer Stein sie geschickt.",
            "Pone el mensaje como si otro ladrillo lo hubiera enviado.",
        ),
        MESSAGE,
        targets = SECOND,
    )
    value(
        "Message()",
        "@(0xf0000)",
        ApiHelp(
            "The last message of another brick, 0 if there is none.",
            "Die letzte Nachricht eines anderen Steins, 0 wenn keine da ist.",
            "El último mensaje de otro ladrillo, 0 si no hay.",
        ),
    )
    function(
        "SetTxPower(const int power)",
        "asm { 0x31, power };",
        ApiHelp(
            "Sets how far infrared light reaches: TX_POWER_LO or TX_POWER_HI.",
            "Stellt ein, wie weit das Infrarotlicht reicht: TX_POWER_LO oder TX_POWER_HI.",
            "Ajusta el alcance de los infrarrojos: TX_POWER_LO o TX_POWER_HI.",
        ),
    )
    constants(
        "TX_POWER_LO=0 TX_POWER_HI=1",
        ApiHelp("A reach of infrared light.", "Eine Reichweite des Infrarotlichts.", "Un alcance de los infrarrojos."),
    )
}

internal val TASK_API = api(NqcApiGroup.TASKS) {
    function(
        "StopAllTasks()",
        "asm { 0x50 };",
        ApiHelp(
            "Stops all tasks, and so the program.",
            "Hält alle Tasks an, also das Programm.",
            "Para todas las tareas, y así el programa.",
        ),
    )
    function(
        "SetPriority(const int priority)",
        "asm { 0xd7, priority };",
        ApiHelp(
            "Sets how important this task is for acquire; 0 is the highest.",
            "Stellt ein, wie wichtig dieser Task für acquire ist; 0 ist am wichtigsten.",
            "Ajusta la importancia de esta tarea para acquire; 0 es la mayor.",
        ),
        PRIORITY,
        targets = SECOND,
    )
    function(
        "SelectProgram(const int program)",
        "asm { 0x91, program };",
        ApiHelp(
            "Stops this program and selects program 0 to 4.",
            "Beendet dieses Programm und wählt Programm 0 bis 4.",
            "Termina este programa y elige el programa 0 a 4.",
        ),
        PROGRAM,
        targets = SECOND,
    )
    value(
        "Program()",
        "@(0x80000)",
        ApiHelp(
            "The number of this program, 0 to 4.",
            "Die Nummer dieses Programms, 0 bis 4.",
            "El número de este programa, de 0 a 4.",
        ),
    )
}

internal val OTHER_API = api(NqcApiGroup.OTHER) {
    value(
        "Random(n)",
        "@(0x40000 + (n))",
        ApiHelp("A random number from 0 to n.", "Eine Zufallszahl von 0 bis n.", "Un número al azar de 0 a n."),
    )
    function(
        "SetRandomSeed(const int &seed)",
        "Set(Random(0), seed);",
        ApiHelp(
            "The same seed gives the same random numbers.",
            "Derselbe Startwert ergibt dieselben Zufallszahlen.",
            "La misma semilla da los mismos números al azar.",
        ),
        targets = SECOND,
    )
    value(
        "BatteryLevel()",
        "@(0x220000)",
        ApiHelp(
            "The battery in thousandths of a volt.",
            "Die Batterie in Tausendstel Volt.",
            "La pila en milésimas de voltio.",
        ),
        SECOND,
    )
    value(
        "FirmwareVersion()",
        "@(0x230000)",
        ApiHelp(
            "The version of the firmware, such as 328.",
            "Die Version der Firmware, etwa 328.",
            "La versión del firmware, como 328.",
        ),
        SECOND,
    )
    value(
        "Indirect(n)",
        "@(0x240000 + (n))",
        ApiHelp(
            "The variable whose number is in variable n.",
            "Die Variable, deren Nummer in Variable n steht.",
            "La variable cuyo número está en la variable n.",
        ),
        SECOND,
    )
    function(
        "SetIndirectVar(const int &variable, const int &value)",
        "asm { 0x05, 0x24, \$variable : 0x3000001, \$value };",
        ApiHelp(
            "Assigns a value to the variable whose number is in a variable.",
            "Weist der Variablen, deren Nummer in einer Variablen steht, einen Wert zu.",
            "Asigna un valor a la variable cuyo número está en una variable.",
        ),
        targets = SECOND,
    )
    function(
        "Set(const int &target, const int &value)",
        "asm { 0x05, \$target : 0x1000000, \$value };",
        ApiHelp(
            "Assigns to anything that can be set, such as Timer(0).",
            "Weist allem, was sich setzen lässt, einen Wert zu, etwa Timer(0).",
            "Asigna un valor a lo que se puede ajustar, como Timer(0).",
        ),
        targets = SECOND,
    )
}
