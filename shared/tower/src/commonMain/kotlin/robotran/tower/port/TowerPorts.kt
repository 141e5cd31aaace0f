package robotran.tower.port

/** The towers of a machine, as far as its platform lets the app reach them. */
interface TowerPorts {
    /** The kinds of towers that can be opened here; empty where the platform allows none, such as in Firefox. */
    val kinds: Set<TowerKind>

    /** Towers that can be opened without asking the user. The likeliest one is first. */
    suspend fun available(): List<TowerDevice>

    /**
     * Asks the user for a tower of [kind] by a dialog of the platform; null if the user cancels it. Browsers show the
     * dialog only within a few seconds of a click. Platforms without such a dialog return the first available tower.
     */
    suspend fun choose(kind: TowerKind): TowerDevice?

    /** Opens [device] with 2400 baud, 8 data bits, odd parity and 1 stop bit. */
    suspend fun open(device: TowerDevice): OpenedTower
}

/** The result of [TowerPorts.open]. */
sealed interface OpenedTower {
    data class Success(val port: TowerPort) : OpenedTower

    data class Failure(val reason: OpenFailure) : OpenedTower
}

/** Why a tower could not be opened. */
enum class OpenFailure {
    /** It was unplugged, or its port does not exist. */
    GONE,

    /** Another program, or another window, has it open. */
    BUSY,

    /** The user, or the system, does not allow the app to use it. */
    NOT_ALLOWED,

    /** A driver of the system holds it, so that the app cannot. */
    HELD_BY_DRIVER,
}

/** A platform that reaches no tower. */
object NoTowerPorts : TowerPorts {
    override val kinds: Set<TowerKind> get() = emptySet()

    override suspend fun available(): List<TowerDevice> = emptyList()

    override suspend fun choose(kind: TowerKind): TowerDevice? = null

    override suspend fun open(device: TowerDevice): OpenedTower = OpenedTower.Failure(OpenFailure.GONE)
}
