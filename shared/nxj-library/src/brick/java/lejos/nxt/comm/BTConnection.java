package lejos.nxt.comm;

/** A Bluetooth connection between two robots. */
public class BTConnection extends LinkConnection {
    BTConnection(int link) {
        super(link);
    }
}
