package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.COUNTER
import robotran.nqc.config.ParameterLimit.HOUR
import robotran.nqc.config.ParameterLimit.MINUTE
import robotran.nqc.config.ParameterLimit.SLEEP_TIME
import robotran.nqc.config.ParameterLimit.TIMER
import robotran.nqc.config.ParameterLimit.WAIT

internal val TIME_API = api(NqcApiGroup.TIME) {
    function(
        "Wait(const int &time)",
        "asm { 0x43, \$time : {random} };",
        ApiHelp(
            "Waits for a time in hundredths of a second; other tasks go on.",
            "Wartet eine Zeit in Hundertstelsekunden; andere Tasks laufen weiter.",
            "Espera un tiempo en centésimas de segundo; las otras tareas siguen.",
        ),
        WAIT,
    )
    value(
        "until(condition)",
        "while (!(condition))",
        ApiHelp(
            "Waits until a condition is true, for example SENSOR_1 == 1.",
            "Wartet, bis eine Bedingung wahr ist, zum Beispiel SENSOR_1 == 1.",
            "Espera hasta que una condición sea cierta, por ejemplo SENSOR_1 == 1.",
        ),
    )
    function(
        "ClearTimer(const int n)",
        "asm { 0xa1, n };",
        ApiHelp("Sets timer 0 to 3 to zero.", "Setzt Timer 0 bis 3 auf null.", "Pone a cero el temporizador 0 a 3."),
        TIMER,
    )
    function(
        "SetTimer(const int n, const int &value)",
        "Set(Timer(n), value);",
        ApiHelp(
            "Sets timer 0 to 3 to a value in tenths of a second.",
            "Stellt Timer 0 bis 3 auf einen Wert in Zehntelsekunden.",
            "Ajusta el temporizador 0 a 3 en décimas de segundo.",
        ),
        TIMER,
        targets = SECOND,
    )
    value(
        "Timer(n)",
        "@(0x10000 + (n))",
        ApiHelp(
            "The time of timer 0 to 3 in tenths of a second.",
            "Die Zeit von Timer 0 bis 3 in Zehntelsekunden.",
            "El tiempo del temporizador 0 a 3 en décimas de segundo.",
        ),
    )
    value(
        "FastTimer(n)",
        "@(0x1a0000 + (n))",
        ApiHelp(
            "The time of timer 0 to 3 in hundredths of a second.",
            "Die Zeit von Timer 0 bis 3 in Hundertstelsekunden.",
            "El tiempo del temporizador 0 a 3 en centésimas de segundo.",
        ),
        SECOND,
    )
    function(
        "SetWatch(const int hours, const int minutes)",
        "asm { 0x22, hours, minutes };",
        ApiHelp("Sets the brick's clock.", "Stellt die Uhr des Steins.", "Pone en hora el reloj del ladrillo."),
        HOUR,
        MINUTE,
    )
    value(
        "Watch()",
        "@(0xe0000)",
        ApiHelp(
            "The brick's clock in minutes.",
            "Die Uhr des Steins in Minuten.",
            "El reloj del ladrillo en minutos.",
        ),
    )
    function(
        "SetSleepTime(const int minutes)",
        "asm { 0xb1, minutes };",
        ApiHelp(
            "After so many minutes the brick switches itself off; 0 means never.",
            "Nach so vielen Minuten schaltet der Stein sich aus; 0 heißt nie.",
            "Tras tantos minutos el ladrillo se apaga; 0 significa nunca.",
        ),
        SLEEP_TIME,
    )
    function(
        "SleepNow()",
        "asm { 0x60 };",
        ApiHelp("Switches the brick off.", "Schaltet den Stein aus.", "Apaga el ladrillo."),
    )
    constants(
        "T1=0 T2=1 T3=2 T4=3",
        ApiHelp("The number of a timer.", "Die Nummer eines Timers.", "El número de un temporizador."),
    )
    function(
        "IncCounter(const int n)",
        "asm { 0x97, n };",
        ApiHelp("Adds 1 to counter 0 to 2.", "Erhöht Zähler 0 bis 2 um 1.", "Suma 1 al contador 0 a 2."),
        COUNTER,
        targets = SECOND,
    )
    function(
        "DecCounter(const int n)",
        "asm { 0xa7, n };",
        ApiHelp("Takes 1 from counter 0 to 2.", "Verringert Zähler 0 bis 2 um 1.", "Resta 1 al contador 0 a 2."),
        COUNTER,
        targets = SECOND,
    )
    function(
        "ClearCounter(const int n)",
        "asm { 0xb7, n };",
        ApiHelp("Sets counter 0 to 2 to zero.", "Setzt Zähler 0 bis 2 auf null.", "Pone a cero el contador 0 a 2."),
        COUNTER,
        targets = SECOND,
    )
    value(
        "Counter(n)",
        "@(0x150000 + (n))",
        ApiHelp(
            "Counter 0 to 2; it is the same place as variable 0 to 2, so write #pragma reserve 0 2.",
            "Zähler 0 bis 2; er ist derselbe Platz wie Variable 0 bis 2, also schreib #pragma reserve 0 2.",
            "El contador 0 a 2; es el mismo lugar que la variable 0 a 2, así que escribe #pragma reserve 0 2.",
        ),
        SECOND,
    )
}
