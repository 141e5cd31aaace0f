package javax.bluetooth;

import java.io.IOException;

/** Bluetooth cannot do what it is asked for at the moment. */
public class BluetoothStateException extends IOException {
    /** Makes one without a text. */
    public BluetoothStateException() {
    }

    /** Makes one with a text. */
    public BluetoothStateException(String msg) {
        super(msg);
    }
}
