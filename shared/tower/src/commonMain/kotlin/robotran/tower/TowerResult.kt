package robotran.tower

/** The result of asking a brick something. */
sealed interface TowerResult<out T> {
    data class Success<T>(val value: T) : TowerResult<T>

    data class Failure(val error: TowerError) : TowerResult<Nothing>
}
