package robotran.android.sound

import org.robolectric.annotation.Implementation
import org.robolectric.annotation.Implements

/**
 * A player of sounds that tells Android's audio service nothing. Robolectric cannot stand in for that service: its interface names a class
 * of Bluetooth that the framework's jar lacks.
 */
@Implements(className = "android.media.PlayerBase", isInAndroidSdk = false)
class UnknownPlayer {
    @Implementation
    fun baseRegisterPlayer(session: Int) = Unit

    @Implementation
    fun baseStart(device: Int) = Unit

    @Implementation
    fun basePause() = Unit

    @Implementation
    fun baseStop() = Unit

    @Implementation
    fun baseRelease() = Unit
}
