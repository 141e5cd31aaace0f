package robotran.nqc.api

import robotran.nqc.config.ParameterLimit.DECIMALS
import robotran.nqc.config.ParameterLimit.DISPLAY
import robotran.nqc.config.ParameterLimit.ENTRIES

internal val DISPLAY_API = api(NqcApiGroup.DISPLAY) {
    function(
        "SelectDisplay(const int &view)",
        "asm { 0x33, \$view : {basic} };",
        ApiHelp(
            "Chooses what the display shows, like the View button.",
            "Wählt, was die Anzeige zeigt, wie die Taste View.",
            "Elige qué muestra la pantalla, como el botón View.",
        ),
        DISPLAY,
    )
    function(
        "SetUserDisplay(const int &value, const int decimals)",
        "asm { 0xe5, 0, decimals, \$value : 0x4000000 };",
        ApiHelp(
            "Sets the value that the display shows after SelectDisplay(DISPLAY_USER); a variable is always read anew.",
            "Stellt den Wert ein, den die Anzeige nach SelectDisplay(DISPLAY_USER) zeigt; eine Variable wird immer " +
                "neu gelesen.",
            "Ajusta el valor que la pantalla muestra tras SelectDisplay(DISPLAY_USER); una variable se lee siempre.",
        ),
        null,
        DECIMALS,
        targets = SECOND,
    )
    constants(
        "DISPLAY_WATCH=0 DISPLAY_SENSOR_1=1 DISPLAY_SENSOR_2=2 DISPLAY_SENSOR_3=3 DISPLAY_OUT_A=4 DISPLAY_OUT_B=5 " +
            "DISPLAY_OUT_C=6",
        ApiHelp("A view of the display.", "Eine Ansicht der Anzeige.", "Una vista de la pantalla."),
    )
    constants(
        "DISPLAY_USER=7",
        ApiHelp(
            "The display shows the value of SetUserDisplay.",
            "Die Anzeige zeigt den Wert von SetUserDisplay.",
            "La pantalla muestra el valor de SetUserDisplay.",
        ),
        SECOND,
    )
}

internal val DATALOG_API = api(NqcApiGroup.DATALOG) {
    function(
        "CreateDatalog(const int size)",
        "asm { 0x52, size, size >> 8 };",
        ApiHelp(
            "Makes a new datalog with room for so many values; 0 removes it.",
            "Legt ein neues Datenlog mit Platz für so viele Werte an; 0 entfernt es.",
            "Crea un registro de datos nuevo para tantos valores; 0 lo elimina.",
        ),
        ENTRIES,
    )
    function(
        "AddToDatalog(const int &value)",
        "asm { 0x62, \$value : 0x5004203 };",
        ApiHelp(
            "Adds a value to the datalog, if it has room.",
            "Fügt dem Datenlog einen Wert an, wenn noch Platz ist.",
            "Añade un valor al registro de datos, si hay sitio.",
        ),
    )
    function(
        "UploadDatalog(const int first, const int count)",
        "asm { 0xa4, first, first >> 8, count, count >> 8 };",
        ApiHelp(
            "Sends values of the datalog to the computer.",
            "Schickt Werte des Datenlogs an den Computer.",
            "Envía valores del registro de datos al ordenador.",
        ),
        ENTRIES,
        ENTRIES,
    )
    value(
        "DatalogType(n)",
        "@@(0x2625)[n]",
        ApiHelp("The kind of entry n.", "Die Art von Eintrag n.", "La clase de la entrada n."),
        SECOND,
    )
    value(
        "DatalogValue(n)",
        "@@(0x2827)[n]",
        ApiHelp("The value of entry n.", "Der Wert von Eintrag n.", "El valor de la entrada n."),
        SECOND,
    )
    value(
        "DatalogByte(n)",
        "@@(0x2a29)[n]",
        ApiHelp("Byte n of the datalog.", "Byte n des Datenlogs.", "El byte n del registro de datos."),
        SECOND,
    )
}
