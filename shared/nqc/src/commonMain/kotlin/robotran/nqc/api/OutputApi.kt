package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.OUTPUTS
import robotran.nqc.config.ParameterLimit.POWER
import robotran.nqc.config.ParameterLimit.WAIT

/** Motors. Command bytes: `shared/lego-firmware`, Opcode. */
internal val OUTPUT_API = api(NqcApiGroup.OUTPUTS) {
    function(
        "On(const int outputs)",
        "SetOutput(outputs, 0x80);",
        ApiHelp("Switches motors on.", "Schaltet Motoren ein.", "Enciende motores."),
        OUTPUTS,
    )
    function(
        "Off(const int outputs)",
        "SetOutput(outputs, 0x40);",
        ApiHelp("Stops motors and brakes them.", "Hält Motoren an und bremst sie.", "Para los motores y los frena."),
        OUTPUTS,
    )
    function(
        "Float(const int outputs)",
        "SetOutput(outputs, 0);",
        ApiHelp(
            "Switches motors off and lets them roll on.",
            "Schaltet Motoren aus und lässt sie ausrollen.",
            "Apaga los motores y los deja rodar.",
        ),
        OUTPUTS,
    )
    function(
        "Fwd(const int outputs)",
        "SetDirection(outputs, 0x80);",
        ApiHelp(
            "Sets the direction of motors to forward, without switching them on.",
            "Stellt Motoren auf vorwärts, ohne sie einzuschalten.",
            "Pone los motores hacia adelante, sin encenderlos.",
        ),
        OUTPUTS,
    )
    function(
        "Rev(const int outputs)",
        "SetDirection(outputs, 0);",
        ApiHelp(
            "Sets the direction of motors to backward, without switching them on.",
            "Stellt Motoren auf rückwärts, ohne sie einzuschalten.",
            "Pone los motores hacia atrás, sin encenderlos.",
        ),
        OUTPUTS,
    )
    function(
        "Toggle(const int outputs)",
        "SetDirection(outputs, 0x40);",
        ApiHelp(
            "Turns the direction of motors round.",
            "Kehrt die Richtung von Motoren um.",
            "Invierte la dirección de los motores.",
        ),
        OUTPUTS,
    )
    function(
        "OnFwd(const int outputs)",
        "Fwd(outputs); On(outputs);",
        ApiHelp(
            "Switches motors on, forward.",
            "Schaltet Motoren vorwärts ein.",
            "Enciende motores hacia adelante.",
        ),
        OUTPUTS,
    )
    function(
        "OnRev(const int outputs)",
        "Rev(outputs); On(outputs);",
        ApiHelp(
            "Switches motors on, backward.",
            "Schaltet Motoren rückwärts ein.",
            "Enciende motores hacia atrás.",
        ),
        OUTPUTS,
    )
    function(
        "OnFor(const int outputs, const int &time)",
        "On(outputs); Wait(time); Off(outputs);",
        ApiHelp(
            "Switches motors on for a time in hundredths of a second.",
            "Schaltet Motoren für eine Zeit in Hundertstelsekunden ein.",
            "Enciende motores durante un tiempo en centésimas de segundo.",
        ),
        OUTPUTS,
        WAIT,
    )
    function(
        "SetOutput(const int outputs, const int mode)",
        "asm { 0x21, outputs + mode };",
        ApiHelp(
            "Switches motors to OUT_ON, OUT_OFF or OUT_FLOAT.",
            "Schaltet Motoren auf OUT_ON, OUT_OFF oder OUT_FLOAT.",
            "Pone los motores en OUT_ON, OUT_OFF o OUT_FLOAT.",
        ),
        OUTPUTS,
    )
    function(
        "SetDirection(const int outputs, const int direction)",
        "asm { 0xe1, outputs + direction };",
        ApiHelp(
            "Sets the direction of motors to OUT_FWD, OUT_REV or OUT_TOGGLE.",
            "Stellt die Richtung von Motoren auf OUT_FWD, OUT_REV oder OUT_TOGGLE.",
            "Pone la dirección de los motores en OUT_FWD, OUT_REV u OUT_TOGGLE.",
        ),
        OUTPUTS,
    )
    function(
        "SetPower(const int outputs, const int &power)",
        "asm { 0x13, outputs, \$power : 0x1000000 + {random} };",
        ApiHelp(
            "Sets the power of motors, 0 to 7.",
            "Stellt die Leistung von Motoren ein, 0 bis 7.",
            "Ajusta la potencia de los motores, de 0 a 7.",
        ),
        OUTPUTS,
        POWER,
    )
    function(
        "SetGlobalOutput(const int outputs, const int mode)",
        "asm { 0x67, outputs + mode };",
        ApiHelp(
            "Allows or forbids motors for the whole program: OUT_ON, OUT_OFF or OUT_FLOAT.",
            "Erlaubt oder verbietet Motoren für das ganze Programm: OUT_ON, OUT_OFF oder OUT_FLOAT.",
            "Permite o prohíbe motores para todo el programa: OUT_ON, OUT_OFF u OUT_FLOAT.",
        ),
        OUTPUTS,
        targets = SECOND,
    )
    function(
        "SetGlobalDirection(const int outputs, const int direction)",
        "asm { 0x77, outputs + direction };",
        ApiHelp(
            "Turns the directions of motors round for the whole program: OUT_FWD, OUT_REV or OUT_TOGGLE.",
            "Dreht die Richtungen von Motoren für das ganze Programm um: OUT_FWD, OUT_REV oder OUT_TOGGLE.",
            "Invierte las direcciones de los motores para todo el programa: OUT_FWD, OUT_REV u OUT_TOGGLE.",
        ),
        OUTPUTS,
        targets = SECOND,
    )
    function(
        "SetMaxPower(const int outputs, const int &power)",
        "asm { 0xa3, outputs, \$power : 0x1000000 };",
        ApiHelp(
            "Limits the power of motors for the whole program, 0 to 7.",
            "Begrenzt die Leistung von Motoren für das ganze Programm, 0 bis 7.",
            "Limita la potencia de los motores para todo el programa, de 0 a 7.",
        ),
        OUTPUTS,
        POWER,
        targets = SECOND,
    )
    function(
        "EnableOutput(const int outputs)",
        "SetGlobalOutput(outputs, 0x80);",
        ApiHelp("Allows motors to run.", "Erlaubt Motoren zu laufen.", "Permite que los motores funcionen."),
        OUTPUTS,
        targets = SECOND,
    )
    function(
        "DisableOutput(const int outputs)",
        "SetGlobalOutput(outputs, 0x40);",
        ApiHelp(
            "Stops motors, and they stay off until EnableOutput.",
            "Hält Motoren an, und sie bleiben aus bis EnableOutput.",
            "Para los motores, que siguen apagados hasta EnableOutput.",
        ),
        OUTPUTS,
        targets = SECOND,
    )
    function(
        "InvertOutput(const int outputs)",
        "SetGlobalDirection(outputs, 0);",
        ApiHelp(
            "From now on forward means backward for these motors.",
            "Ab jetzt heißt vorwärts für diese Motoren rückwärts.",
            "Desde ahora, adelante significa atrás para estos motores.",
        ),
        OUTPUTS,
        targets = SECOND,
    )
    function(
        "ObvertOutput(const int outputs)",
        "SetGlobalDirection(outputs, 0x80);",
        ApiHelp("Ends InvertOutput.", "Beendet InvertOutput.", "Termina InvertOutput."),
        OUTPUTS,
        targets = SECOND,
    )
    value(
        "OutputStatus(n)",
        "@(0x30000 + (n))",
        ApiHelp(
            "The state of motor 0, 1 or 2 as a number: power, direction and mode.",
            "Der Zustand von Motor 0, 1 oder 2 als Zahl: Leistung, Richtung und Modus.",
            "El estado del motor 0, 1 o 2 como número: potencia, dirección y modo.",
        ),
    )
    value(
        "GlobalOutputStatus(n)",
        "@(0x110000 + (n))",
        ApiHelp(
            "What the whole program allows motor 0, 1 or 2, as a number.",
            "Was das ganze Programm Motor 0, 1 oder 2 erlaubt, als Zahl.",
            "Lo que todo el programa permite al motor 0, 1 o 2, como número.",
        ),
        SECOND,
    )
    constants(
        "OUT_A=1 OUT_B=2 OUT_C=4 OUT_AB=3 OUT_AC=5 OUT_BC=6 OUT_ABC=7",
        ApiHelp("Motors at outputs A, B and C.", "Motoren an den Ausgängen A, B und C.", "Motores en A, B y C."),
    )
    constants(
        "OUT_FLOAT=0 OUT_OFF=0x40 OUT_ON=0x80",
        ApiHelp("A mode of motors.", "Ein Modus von Motoren.", "Un modo de los motores."),
    )
    constants(
        "OUT_REV=0 OUT_TOGGLE=0x40 OUT_FWD=0x80",
        ApiHelp("A direction of motors.", "Eine Richtung von Motoren.", "Una dirección de los motores."),
    )
    constants(
        "OUT_LOW=0 OUT_HALF=3 OUT_FULL=7",
        ApiHelp("A power of motors.", "Eine Leistung von Motoren.", "Una potencia de los motores."),
    )
}
