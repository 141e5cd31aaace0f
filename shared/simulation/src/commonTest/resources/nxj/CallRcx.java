import lejos.nxt.SensorPort;
import lejos.nxt.addon.RCXLink;
import lejos.util.Delay;

/** Asks an RCX whether it is there, shows its answer, and sends a message. */
public class CallRcx {
    public static void main(String[] arguments) {
        RCXLink link = new RCXLink(SensorPort.S1);
        link.ping();
        Delay.msDelay(300);
        byte[] answer = new byte[link.bytesAvailable()];
        System.out.println(link.readBytes(answer));
        for (int place = 3; place < answer.length; place++) System.out.print((answer[place] & 0xFF) + " ");
        System.out.println(link.bytesAvailable());
        link.sendF7(66);
        Delay.msDelay(100000);
    }
}
