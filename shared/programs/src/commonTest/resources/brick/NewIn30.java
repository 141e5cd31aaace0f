import java.util.Vector;
import josx.platform.rcx.Message;
import josx.rcxcomm.remotecontrol.RemoteControlAdapter;

/** What came or moved between leJOS 2.1 and 3.0. */
public class NewIn30 {
    static class Remote extends RemoteControlAdapter { // brick lejos 2.1 error: josx.platform.rcx.remotecontrol
    }

    public static void main(String[] args) {
        Message.send((byte) 7); // brick lejos 2.1 error: Serial.sendPacket
        java.util.Queue queue = null; // brick lejos 2.1 error: There, use a Vector
        int last = new Vector().lastIndexOf(null); // brick lejos 2.1 error: from the last one to the first
    }
}
