import java.util.Date;

// only here
public class DatesOfABrick {
    public static void main(String[] arguments) {
        Date date = new Date();
        System.out.println(date.getYear() + " " + date.getMonth() + " " + date.getDate() + " " + date.getHours()); // expect 2000 1 1 0
        date.setYear(12);
        date.setMonth(13);
        date.setDate(31);
        date.setHours(24);
        date.setMinutes(59);
        date.setSeconds(7);
        System.out.println(date.getYear() + " " + date.getMonth() + " " + date.getDate()); // expect 2012 1 31
        System.out.println(date.getHours() + ":" + date.getMinutes() + ":" + date.getSeconds()); // expect 0:59:7
        System.out.println(new Date().before(date) + " " + date.after(new Date()) + " " + new Date().equals(new Date())); // expect false false false
    }
}
