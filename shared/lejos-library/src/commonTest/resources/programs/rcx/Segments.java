import josx.platform.rcx.LCD;
import josx.platform.rcx.Segment;

public class Segments {
    public static void main(String[] arguments) {
        LCD.setSegment(Segment.STANDING); // rom: 0x1b62 0x3006
        LCD.clearSegment(Segment.WALKING); // rom: 0x1e4a 0x3007
        LCD.setSegment(Segment.SENSOR_1_VIEW); // rom: 0x1b62 0x3008
        LCD.setSegment(Segment.SENSOR_2_ACTIVE); // rom: 0x1b62 0x300b
        LCD.setSegment(Segment.SENSOR_3_ACTIVE); // rom: 0x1b62 0x300d
        LCD.setSegment(Segment.MOTOR_A_VIEW); // rom: 0x1b62 0x300e
        LCD.setSegment(Segment.MOTOR_B_FWD); // rom: 0x1b62 0x3013
        LCD.setSegment(Segment.MOTOR_C_REV); // rom: 0x1b62 0x3015
        LCD.setSegment(Segment.DATALOG); // rom: 0x1b62 0x3018
        LCD.setSegment(Segment.DOWNLOAD); // rom: 0x1b62 0x3019
        LCD.setSegment(Segment.UPLOAD); // rom: 0x1b62 0x301a
        LCD.setSegment(Segment.BATTERY); // rom: 0x1b62 0x301b
        LCD.setSegment(Segment.RANGE_SHORT); // rom: 0x1b62 0x301c
        LCD.setSegment(Segment.RANGE_LONG); // rom: 0x1b62 0x301d
        LCD.setSegment(Segment.ALL); // rom: 0x1b62 0x3020
        LCD.refresh(); // rom: 0x27c8
    }
}
