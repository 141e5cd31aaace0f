package lejos.nxt.rcxcomm;

/** The first byte of LEGO's infrared packets: it says what the packet is about. */
public interface Opcode {
    /** Leaves the bit out that is turned around in each second packet. */
    byte OPCODE_MASK = (byte) 0xF7;

    /** Alive. */
    byte OPCODE_ALIVE = 0x10;

    /** Get value. */
    byte OPCODE_GET_VALUE = 0x12;

    /** Set motor power. */
    byte OPCODE_SET_MOTOR_POWER = 0x13;

    /** Set variable. */
    byte OPCODE_SET_VARIABLE = 0x14;

    /** Get versions. */
    byte OPCODE_GET_VERSIONS = 0x15;

    /** Answers to set motor direction. */
    byte OPCODE_SET_MOTOR_DIRECTION_REPLY = 0x16;

    /** Call subroutine. */
    byte OPCODE_CALL_SUBROUTINE = 0x17;

    /** Get memory map. */
    byte OPCODE_GET_MEMORY_MAP = 0x20;

    /** Set motor on off. */
    byte OPCODE_SET_MOTOR_ON_OFF = 0x21;

    /** Set time. */
    byte OPCODE_SET_TIME = 0x22;

    /** Play tone. */
    byte OPCODE_PLAY_TONE = 0x23;

    /** Add to variable. */
    byte OPCODE_ADD_TO_VARIABLE = 0x24;

    /** Start task download. */
    byte OPCODE_START_TASK_DOWNLOAD = 0x25;

    /** Answers to clear sensor value. */
    byte OPCODE_CLEAR_SENSOR_VALUE_REPLY = 0x26;

    /** Branch always near. */
    byte OPCODE_BRANCH_ALWAYS_NEAR = 0x27;

    /** Get battery power. */
    byte OPCODE_GET_BATTERY_POWER = 0x30;

    /** Set transmitter range. */
    byte OPCODE_SET_TRANSMITTER_RANGE = 0x31;

    /** Set sensor type. */
    byte OPCODE_SET_SENSOR_TYPE = 0x32;

    /** Set display. */
    byte OPCODE_SET_DISPLAY = 0x33;

    /** Subtract from variable. */
    byte OPCODE_SUBTRACT_FROM_VARIABLE = 0x34;

    /** Start subroutine download. */
    byte OPCODE_START_SUBROUTINE_DOWNLOAD = 0x35;

    /** Answers to delete subroutine. */
    byte OPCODE_DELETE_SUBROUTINE_REPLY = 0x36;

    /** Decrement loop counter near. */
    byte OPCODE_DECREMENT_LOOP_COUNTER_NEAR = 0x37;

    /** Delete all tasks. */
    byte OPCODE_DELETE_ALL_TASKS = 0x40;

    /** Set sensor mode. */
    byte OPCODE_SET_SENSOR_MODE = 0x42;

    /** Wait. */
    byte OPCODE_WAIT = 0x43;

    /** Divide variable. */
    byte OPCODE_DIVIDE_VARIABLE = 0x44;

    /** Transfer data. */
    byte OPCODE_TRANSFER_DATA = 0x45;

    /** Answers to set power down delay. */
    byte OPCODE_SET_POWER_DOWN_DELAY_REPLY = 0x46;

    /** Stop all tasks. */
    byte OPCODE_STOP_ALL_TASKS = 0x50;

    /** Set datalog size. */
    byte OPCODE_SET_DATALOG_SIZE = 0x52;

    /** Answers to unlock firmware. */
    byte OPCODE_UNLOCK_FIRMWARE_REPLY = 0x52;

    /** Answers to upload datalog. */
    byte OPCODE_UPLOAD_DATALOG_REPLY = 0x53;

    /** Multiply variable. */
    byte OPCODE_MULTIPLY_VARIABLE = 0x54;

    /** Answers to clear timer. */
    byte OPCODE_CLEAR_TIMER_REPLY = 0x56;

    /** Power off. */
    byte OPCODE_POWER_OFF = 0x60;

    /** Delete task. */
    byte OPCODE_DELETE_TASK = 0x61;

    /** Datalog next. */
    byte OPCODE_DATALOG_NEXT = 0x62;

    /** Answers to or variable. */
    byte OPCODE_OR_VARIABLE_REPLY = 0x63;

    /** Sign variable. */
    byte OPCODE_SIGN_VARIABLE = 0x64;

    /** Delete firmware. */
    byte OPCODE_DELETE_FIRMWARE = 0x65;

    /** Answers to set program number. */
    byte OPCODE_SET_PROGRAM_NUMBER_REPLY = 0x66;

    /** Delete all subroutines. */
    byte OPCODE_DELETE_ALL_SUBROUTINES = 0x70;

    /** Start task. */
    byte OPCODE_START_TASK = 0x71;

    /** Branch always far. */
    byte OPCODE_BRANCH_ALWAYS_FAR = 0x72;

    /** Answers to and variable. */
    byte OPCODE_AND_VARIABLE_REPLY = 0x73;

    /** Absolute value. */
    byte OPCODE_ABSOLUTE_VALUE = 0x74;

    /** Start firmware download. */
    byte OPCODE_START_FIRMWARE_DOWNLOAD = 0x75;

    /** Answers to stop task. */
    byte OPCODE_STOP_TASK_REPLY = 0x76;

    /** Stop task. */
    byte OPCODE_STOP_TASK = (byte) 0x81;

    /** Answers to start firmware download. */
    byte OPCODE_START_FIRMWARE_DOWNLOAD_REPLY = (byte) 0x82;

    /** Set loop counter. */
    byte OPCODE_SET_LOOP_COUNTER = (byte) 0x82;

    /** Answers to absolute value. */
    byte OPCODE_ABSOLUTE_VALUE_REPLY = (byte) 0x83;

    /** And variable. */
    byte OPCODE_AND_VARIABLE = (byte) 0x84;

    /** Test and branch near. */
    byte OPCODE_TEST_AND_BRANCH_NEAR = (byte) 0x85;

    /** Answers to start task. */
    byte OPCODE_START_TASK_REPLY = (byte) 0x86;

    /** Answers to delete all subroutines. */
    byte OPCODE_DELETE_ALL_SUBROUTINES_REPLY = (byte) 0x87;

    /** Clear message. */
    byte OPCODE_CLEAR_MESSAGE = (byte) 0x90;

    /** Set program number. */
    byte OPCODE_SET_PROGRAM_NUMBER = (byte) 0x91;

    /** Answers to delete firmware. */
    byte OPCODE_DELETE_FIRMWARE_REPLY = (byte) 0x92;

    /** Decrement loop counter far. */
    byte OPCODE_DECREMENT_LOOP_COUNTER_FAR = (byte) 0x92;

    /** Answers to sign variable. */
    byte OPCODE_SIGN_VARIABLE_REPLY = (byte) 0x93;

    /** Or variable. */
    byte OPCODE_OR_VARIABLE = (byte) 0x94;

    /** Answers to datalog next. */
    byte OPCODE_DATALOG_NEXT_REPLY = (byte) 0x95;

    /** Test and branch far. */
    byte OPCODE_TEST_AND_BRANCH_FAR = (byte) 0x95;

    /** Answers to delete task. */
    byte OPCODE_DELETE_TASK_REPLY = (byte) 0x96;

    /** Answers to power off. */
    byte OPCODE_POWER_OFF_REPLY = (byte) 0x97;

    /** Clear timer. */
    byte OPCODE_CLEAR_TIMER = (byte) 0xA1;

    /** Answers to multiply variable. */
    byte OPCODE_MULTIPLY_VARIABLE_REPLY = (byte) 0xA3;

    /** Upload datalog. */
    byte OPCODE_UPLOAD_DATALOG = (byte) 0xA4;

    /** Unlock firmware. */
    byte OPCODE_UNLOCK_FIRMWARE = (byte) 0xA5;

    /** Answers to set datalog size. */
    byte OPCODE_SET_DATALOG_SIZE_REPLY = (byte) 0xA5;

    /** Answers to play sound. */
    byte OPCODE_PLAY_SOUND_REPLY = (byte) 0xA6;

    /** Answers to stop all tasks. */
    byte OPCODE_STOP_ALL_TASKS_REPLY = (byte) 0xA7;

    /** Set power down delay. */
    byte OPCODE_SET_POWER_DOWN_DELAY = (byte) 0xB1;

    /** Answers to transfer data. */
    byte OPCODE_TRANSFER_DATA_REPLY = (byte) 0xB2;

    /** Send message. */
    byte OPCODE_SEND_MESSAGE = (byte) 0xB2;

    /** Answers to divide variable. */
    byte OPCODE_DIVIDE_VARIABLE_REPLY = (byte) 0xB3;

    /** Answers to set sensor mode. */
    byte OPCODE_SET_SENSOR_MODE_REPLY = (byte) 0xB5;

    /** Answers to delete all tasks. */
    byte OPCODE_DELETE_ALL_TASKS_REPLY = (byte) 0xB7;

    /** Delete subroutine. */
    byte OPCODE_DELETE_SUBROUTINE = (byte) 0xC1;

    /** Answers to start subroutine download. */
    byte OPCODE_START_SUBROUTINE_DOWNLOAD_REPLY = (byte) 0xC2;

    /** Answers to subtract from variable. */
    byte OPCODE_SUBTRACT_FROM_VARIABLE_REPLY = (byte) 0xC3;

    /** Answers to set display. */
    byte OPCODE_SET_DISPLAY_REPLY = (byte) 0xC4;

    /** Answers to set sensor type. */
    byte OPCODE_SET_SENSOR_TYPE_REPLY = (byte) 0xC5;

    /** Answers to set transmitter range. */
    byte OPCODE_SET_TRANSMITTER_RANGE_REPLY = (byte) 0xC6;

    /** Answers to get battery power. */
    byte OPCODE_GET_BATTERY_POWER_REPLY = (byte) 0xC7;

    /** Clear sensor value. */
    byte OPCODE_CLEAR_SENSOR_VALUE = (byte) 0xD1;

    /** Answers to start task download. */
    byte OPCODE_START_TASK_DOWNLOAD_REPLY = (byte) 0xD2;

    /** Remote command. */
    byte OPCODE_REMOTE_COMMAND = (byte) 0xD2;

    /** Answers to add to variable. */
    byte OPCODE_ADD_TO_VARIABLE_REPLY = (byte) 0xD3;

    /** Answers to play tone. */
    byte OPCODE_PLAY_TONE_REPLY = (byte) 0xD4;

    /** Answers to set time. */
    byte OPCODE_SET_TIME_REPLY = (byte) 0xD5;

    /** Answers to set motor on off. */
    byte OPCODE_SET_MOTOR_ON_OFF_REPLY = (byte) 0xD6;

    /** Answers to get memory map. */
    byte OPCODE_GET_MEMORY_MAP_REPLY = (byte) 0xD7;

    /** Set motor direction. */
    byte OPCODE_SET_MOTOR_DIRECTION = (byte) 0xE1;

    /** Answers to get versions. */
    byte OPCODE_GET_VERSIONS_REPLY = (byte) 0xE2;

    /** Answers to set variable. */
    byte OPCODE_SET_VARIABLE_REPLY = (byte) 0xE3;

    /** Answers to set motor power. */
    byte OPCODE_SET_MOTOR_POWER_REPLY = (byte) 0xE4;

    /** Answers to get value. */
    byte OPCODE_GET_VALUE_REPLY = (byte) 0xE5;

    /** Answers to alive. */
    byte OPCODE_ALIVE_REPLY = (byte) 0xE7;

    /** Set message. */
    byte OPCODE_SET_MESSAGE = (byte) 0xF7;
}
