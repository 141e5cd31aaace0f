package robotran.cli.messages

import robotran.language.listed

internal object SpanishTowerMessages : TowerMessages {
    override fun lejosHasNoSlots() =
        "leJOS no tiene espacios para varios programas, el ladrillo guarda solo lo último enviado. Nombra varios " +
            "programas en una orden: el botón Prgm los recorre."

    override fun noTower() =
        "No hay ninguna torre. Conéctala, o di su puerto con --port. En Windows y macOS la torre USB solo " +
            "funciona en la página de Robotran, en Chrome."

    override fun noTowerAt(ports: List<String>) =
        "No hay ninguna torre en ${listed(ports, "ni")}. Conecta la torre y mira si su pila está bien."

    override fun portGone(port: String) = "No existe el puerto $port. Conecta la torre, o di otro puerto con --port."

    override fun portBusy(port: String) = "Otro programa usa $port. Ciérralo y prueba otra vez."

    override fun portNotAllowed(port: String) =
        "No puedes usar $port. En Linux, pide a alguien que pueda que te añada al grupo del archivo, muchas veces dialout."

    override fun portHeld(port: String) = "Un controlador del sistema ocupa $port, y Robotran no puede usarlo."

    override fun towerAt(port: String) = "La torre está en $port."

    override fun blocksSent(sent: Int, all: Int, secondsLeft: Int) = "$sent de $all bloques, quedan $secondsLeft s"

    override fun programSent(bytes: Int) = "El ladrillo tiene el programa, $bytes bytes. Pulsa Run."

    override fun programInSlot(slot: Int, bytes: Int) =
        "El ladrillo tiene el programa $slot, $bytes bytes. Elígelo con Prgm y pulsa Run."

    override fun tooFewSlots(slots: Int) =
        "Un ladrillo tiene $slots espacios para programas. Nombra menos programas, o un --slot menor."

    override fun firmwareSent(bytes: Int) = "El ladrillo tiene su firmware, $bytes bytes. Ya puedes enviar programas."

    override fun firmwareIs(name: String, firmware: String) = "$name es $firmware."

    override fun firmwareUnknown(name: String) =
        "$name no es ningún firmware que Robotran conozca. Se envía de todos modos."

    override fun notAFirmware(name: String) =
        "$name no es un firmware. Usa lejos.srec de leJOS, o un archivo de LEGO cuyo nombre termine en .lgo."

    override fun firmwareDamaged(name: String, line: Int) =
        "$name está dañado en la línea $line. Descarga o copia el archivo otra vez."

    override fun firmwareCutOff(name: String) = "$name termina demasiado pronto. Descarga o copia el archivo otra vez."

    override fun firmwareOutOfRange(name: String, line: Int) =
        "$name no es para un RCX: la línea $line es para una memoria que un RCX no tiene."

    override fun firmwareTooLarge(name: String, bytes: Int, limit: Int) =
        "$name es demasiado grande para un RCX: tiene $bytes bytes y pueden ser $limit."

    override fun firmwareForOthers(name: String) =
        "$name no es para un RCX: le falta la frase que un RCX busca antes de iniciar un firmware."

    override fun towerGone() = "La torre se ha desconectado. Conéctala y prueba otra vez."

    override fun towerSilent() =
        "En este puerto no responde nada. Mira si es el de la torre y si la pila de la torre está bien."

    override fun brickSilent() =
        "El ladrillo no responde. Enciéndelo, para su programa y ponlo delante de la torre, a un palmo."

    override fun noLejos() =
        "El ladrillo no tiene leJOS. Envía primero el firmware de leJOS, con robotran firmware lejos.srec."

    override fun noLegoFirmware() = "El ladrillo no tiene el firmware de LEGO, que hace falta para esto."

    override fun badConnection() =
        "La torre y el ladrillo se entienden mal. Ponlos más cerca, sin luz fuerte, con buenas pilas y sin otro " +
            "ladrillo al lado."

    override fun batteryLow(volts: String) = "A las pilas solo les quedan $volts V. Pon primero unas nuevas."

    override fun programTooLarge(bytes: Int, limit: Int) =
        "El programa es demasiado grande para el ladrillo: tiene $bytes bytes y pueden ser $limit."

    override fun brickFull(bytes: Int) =
        "El ladrillo no tiene sitio para $bytes bytes más. Borra programas que ya no necesites."

    override fun firmwareRefused() = "El ladrillo no inicia este firmware. Usa otro archivo o envíalo otra vez."

    override fun brickHasLejosOrNothing(rom: String) =
        "El ladrillo tiene leJOS, o ningún firmware: los dos responden igual. Si la pantalla muestra un voltaje, " +
            "es leJOS. La ROM es la versión $rom."

    override fun brickHasLego(firmware: String, rom: String) =
        "El ladrillo tiene el firmware $firmware de LEGO. La ROM es la versión $rom."

    override fun batteryIs(volts: String) = "Las pilas tienen $volts V."

    override fun brickIsUnknown() = "Responde un ladrillo, pero no dice qué es."
}
