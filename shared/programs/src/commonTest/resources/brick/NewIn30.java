import java.util.Vector;
import josx.platform.rcx.Message;
import josx.rcxcomm.remotecontrol.RemoteControlAdapter;

/** What came or moved between leJOS 2.1 and 3.0. */
public class NewIn30 {
    static class Remote extends RemoteControlAdapter { // error 2.1: josx.platform.rcx.remotecontrol
    }

    public static void main(String[] args) {
        Message.send((byte) 7); // error 2.1: Serial.sendPacket
        java.util.Queue queue = null; // error 2.1: There, use a Vector
        int last = new Vector().lastIndexOf(null); // error 2.1: from the last one to the first
    }
}
