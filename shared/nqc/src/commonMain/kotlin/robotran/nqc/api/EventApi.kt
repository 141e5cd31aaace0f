package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.EVENT

internal val EVENT_API = api(NqcApiGroup.EVENTS) {
    function(
        "SetEvent(const int event, const int &source, const int type)",
        "asm { 0x93, event, __event_src(source), type };",
        ApiHelp(
            "Defines event 0 to 15: a sensor, timer, counter or the message, and what must happen there.",
            "Legt Ereignis 0 bis 15 fest: ein Sensor, Timer, Zähler oder die Nachricht, und was dort geschehen muss.",
            "Define el evento 0 a 15: un sensor, temporizador, contador o el mensaje, y qué debe pasar ahí.",
        ),
        EVENT,
        targets = SECOND,
    )
    function(
        "ClearEvent(const int event)",
        "asm { 0x93, event, 0, 16 };",
        ApiHelp("Forgets an event.", "Vergisst ein Ereignis.", "Olvida un evento."),
        EVENT,
        targets = SECOND,
    )
    function(
        "ClearAllEvents()",
        "asm { 0x06 };",
        ApiHelp("Forgets all events.", "Vergisst alle Ereignisse.", "Olvida todos los eventos."),
        targets = SECOND,
    )
    function(
        "CalibrateEvent(const int event, const int lower, const int upper, const int hysteresis)",
        "asm { 0x04, event, upper, lower, hysteresis };",
        ApiHelp(
            "Sets the limits of an event from what its sensor reads now, in per cent of it.",
            "Stellt die Grenzen eines Ereignisses nach dem ein, was sein Sensor jetzt misst, in Prozent davon.",
            "Ajusta los límites de un evento según lo que su sensor mide ahora, en tanto por ciento.",
        ),
        EVENT,
        targets = SECOND,
    )
    function(
        "Event(const int &events)",
        "asm { 0x03, \$events };",
        ApiHelp(
            "Makes events happen: a sum of EVENT_MASKs.",
            "Lässt Ereignisse geschehen: eine Summe von EVENT_MASK.",
            "Hace que ocurran eventos: una suma de EVENT_MASK.",
        ),
        targets = SECOND,
    )
    setter(
        "SetUpperLimit",
        "UpperLimit",
        ApiHelp(
            "Sets above which value an event is high.",
            "Stellt ein, über welchem Wert ein Ereignis hoch ist.",
            "Ajusta sobre qué valor un evento es alto.",
        ),
    )
    setter(
        "SetLowerLimit",
        "LowerLimit",
        ApiHelp(
            "Sets below which value an event is low.",
            "Stellt ein, unter welchem Wert ein Ereignis niedrig ist.",
            "Ajusta bajo qué valor un evento es bajo.",
        ),
    )
    setter(
        "SetHysteresis",
        "Hysteresis",
        ApiHelp(
            "Sets how far a value must come back from a limit.",
            "Stellt ein, wie weit ein Wert von einer Grenze zurück muss.",
            "Ajusta cuánto debe volver un valor desde un límite.",
        ),
    )
    setter(
        "SetClickTime",
        "ClickTime",
        ApiHelp(
            "Sets how long a click may take, in hundredths of a second.",
            "Stellt ein, wie lange ein Klick dauern darf, in Hundertstelsekunden.",
            "Ajusta cuánto puede durar un clic, en centésimas de segundo.",
        ),
    )
    setter(
        "SetClickCounter",
        "ClickCounter",
        ApiHelp(
            "Sets how many clicks an event has counted.",
            "Stellt ein, wie viele Klicks ein Ereignis gezählt hat.",
            "Ajusta cuántos clics ha contado un evento.",
        ),
    )
    value(
        "ActiveEvents(n)",
        "@(0x170000 + (n))",
        ApiHelp(
            "The events that happened for task n, as a sum of EVENT_MASKs.",
            "Die Ereignisse, die für Task n geschahen, als Summe von EVENT_MASK.",
            "Los eventos que ocurrieron para la tarea n, como suma de EVENT_MASK.",
        ),
        SECOND,
    )
    value(
        "CurrentEvents()",
        "ActiveEvents(10)",
        ApiHelp(
            "The events that happened for this task.",
            "Die Ereignisse, die für diesen Task geschahen.",
            "Los eventos que ocurrieron para esta tarea.",
        ),
        SECOND,
    )
    value(
        "EventState(n)",
        "@(0x190000 + (n))",
        ApiHelp(
            "Whether an event is low 0, normal 1 or high 2.",
            "Ob ein Ereignis niedrig 0, normal 1 oder hoch 2 ist.",
            "Si un evento es bajo 0, normal 1 o alto 2.",
        ),
        SECOND,
    )
    value(
        "UpperLimit(n)",
        "@(0x1c0000 + (n))",
        ApiHelp(
            "Above this value an event is high.",
            "Über diesem Wert ist ein Ereignis hoch.",
            "Sobre este valor un evento es alto.",
        ),
        SECOND,
    )
    value(
        "LowerLimit(n)",
        "@(0x1d0000 + (n))",
        ApiHelp(
            "Below this value an event is low.",
            "Unter diesem Wert ist ein Ereignis niedrig.",
            "Bajo este valor un evento es bajo.",
        ),
        SECOND,
    )
    value(
        "Hysteresis(n)",
        "@(0x1e0000 + (n))",
        ApiHelp(
            "How far a value must come back from a limit.",
            "Wie weit ein Wert von einer Grenze zurück muss.",
            "Cuánto debe volver un valor desde un límite.",
        ),
        SECOND,
    )
    value(
        "ClickTime(n)",
        "@(0x1f0000 + (n))",
        ApiHelp(
            "How long a click may take, in hundredths of a second.",
            "Wie lange ein Klick dauern darf, in Hundertstelsekunden.",
            "Cuánto puede durar un clic, en centésimas de segundo.",
        ),
        SECOND,
    )
    value(
        "ClickCounter(n)",
        "@(0x1b0000 + (n))",
        ApiHelp(
            "How many clicks an event has counted.",
            "Wie viele Klicks ein Ereignis gezählt hat.",
            "Cuántos clics ha contado un evento.",
        ),
        SECOND,
    )
    value(
        "EVENT_MASK(n)",
        "(1 << (n))",
        ApiHelp(
            "An event for monitor and catch; add several with |.",
            "Ein Ereignis für monitor und catch; mehrere verbindest du mit |.",
            "Un evento para monitor y catch; une varios con |.",
        ),
        SECOND,
    )
    constants(
        "EVENT_TYPE_PRESSED=0 EVENT_TYPE_RELEASED=1 EVENT_TYPE_PULSE=2 EVENT_TYPE_EDGE=3 EVENT_TYPE_FASTCHANGE=7 " +
            "EVENT_TYPE_LOW=8 EVENT_TYPE_NORMAL=9 EVENT_TYPE_HIGH=10 EVENT_TYPE_CLICK=11 EVENT_TYPE_DOUBLECLICK=12 " +
            "EVENT_TYPE_MESSAGE=14",
        ApiHelp(
            "What must happen for an event.",
            "Was für ein Ereignis geschehen muss.",
            "Qué debe pasar para un evento.",
        ),
        SECOND,
    )
    constants(
        "ACQUIRE_OUT_A=1 ACQUIRE_OUT_B=2 ACQUIRE_SOUND=4 ACQUIRE_OUT_C=8 ACQUIRE_USER_1=16 ACQUIRE_USER_2=32 " +
            "ACQUIRE_USER_3=64 ACQUIRE_USER_4=128",
        ApiHelp(
            "Something that only one task at a time should use, for acquire.",
            "Etwas, das immer nur ein Task benutzen soll, für acquire.",
            "Algo que solo una tarea a la vez debe usar, para acquire.",
        ),
        SECOND,
    )
}

private fun ApiBuilder.setter(name: String, value: String, help: ApiHelp) = function(
    "$name(const int event, const int &value)",
    "Set($value(event), value);",
    help,
    EVENT,
    targets = SECOND,
)
