import lejos.nxt.SensorPort;
import lejos.nxt.addon.IRSeeker;
import lejos.nxt.addon.IRSeekerV2;
import lejos.util.Delay;

/** Shows where two infrared seekers on the ports 1 and 2 see light. */
public class SeekLamp {
    public static void main(String[] arguments) {
        IRSeeker first = new IRSeeker(SensorPort.S1);
        IRSeekerV2 second = new IRSeekerV2(SensorPort.S2, IRSeekerV2.Mode.AC);
        Delay.msDelay(50);
        System.out.println(first.getDirection() + " " + (first.getSensorValue(3) >= 0));
        System.out.println(second.getDirection() + " " + second.getAngle());
        int[] values = second.getSensorValues();
        System.out.println(values[0] + " " + values[1] + " " + values[2] + " " + values[3] + " " + values[4]);
        second.setMode(IRSeekerV2.Mode.DC);
        System.out.println(second.getDirection() + " " + (second.getAverage(1) > 0));
        Delay.msDelay(100000);
    }
}
