package android.bluetooth

/** A class of Android 16 that Robolectric's Bluetooth names, in place of the one that the Android of the tests lacks. */
@Suppress("unused", "ClassName")
class `BluetoothDevice$BluetoothAddress`
