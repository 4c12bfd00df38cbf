//! The naming conventions of the tools that people use, each with a small skeleton so named.
//!
//! A chain is written `A > *B > *C`: each star is the next of the chain's roles, `@` the joint that
//! the arms leave, `{}` the side. Bones have a person's proportions, so that only names differ.

use motion::body::{self, Role, Side};
use motion::clip::Clip;

struct Convention {
    name: &'static str,
    sides: [&'static str; 2],
    /// Pelvis, neck, head.
    trunk: &'static str,
    /// Shoulder, elbow, wrist, finger.
    arm: &'static str,
    /// Hip, knee, ankle, toe.
    leg: &'static str,
    /// `parent > child` for what else hangs on the body, in each side's name.
    also: &'static [&'static str],
}

const LEFT_RIGHT: [&str; 2] = ["Left", "Right"];

#[rustfmt::skip]
const CONVENTIONS: &[Convention] = &[
    Convention { name: "MotionBuilder", sides: LEFT_RIGHT,
        trunk: "*Hips > Spine > @Spine1 > *Neck > Head > *HeadTop_End",
        arm: "{}Shoulder > *{}Arm > *{}ForeArm > *{}Hand > {}HandMiddle1 > *{}HandMiddle2",
        leg: "*{}UpLeg > *{}Leg > *{}Foot > {}ToeBase > *{}Toe_End",
        also: &["{}Hand > {}HandThumb1 > {}HandThumb2 > {}HandThumb3", "{}Hand > {}HandRing1 > {}HandRing2", "{}ForeArm > {}ForeArmRoll"] },
    Convention { name: "Mixamo", sides: LEFT_RIGHT,
        trunk: "*mixamorig1:Hips > mixamorig1:Spine > @mixamorig1:Spine1 > *mixamorig1:Neck > *mixamorig1:Head",
        arm: "mixamorig1:{}Shoulder > *mixamorig1:{}Arm > *mixamorig1:{}ForeArm > *mixamorig1:{}Hand > *mixamorig1:{}HandMiddle1",
        leg: "*mixamorig1:{}UpLeg > *mixamorig1:{}Leg > *mixamorig1:{}Foot > *mixamorig1:{}ToeBase", also: &[] },
    Convention { name: "HumanIK characters", sides: LEFT_RIGHT,
        trunk: "*Character1_Hips > Character1_Spine > @Character1_Spine1 > *Character1_Neck > *Character1_Head",
        arm: "Character1_{}Shoulder > *Character1_{}Arm > *Character1_{}ForeArm > *Character1_{}Hand > *Character1_{}HandEnd",
        leg: "*Character1_{}UpLeg > *Character1_{}Leg > *Character1_{}Foot > *Character1_{}ToeBase", also: &[] },
    Convention { name: "cgspeed CMU", sides: LEFT_RIGHT,
        trunk: "*Hips > LowerBack > Spine > @Spine1 > *Neck1 > *Head",
        arm: "{}Shoulder > *{}Arm > *{}ForeArm > *{}Hand > {}FingerBase > *{}HandIndex1",
        leg: "{}HipJoint > *{}UpLeg > *{}Leg > *{}Foot > *{}ToeBase", also: &["{}Hand > {}Thumb"] },
    Convention { name: "Biovision", sides: LEFT_RIGHT,
        trunk: "*Hips > Chest > @Chest2 > *Neck > *Head",
        arm: "{}Collar > *{}Shoulder > *{}Elbow > *{}Wrist > *{}Finger2",
        leg: "*{}Hip > *{}Knee > *{}Ankle > *{}Toe", also: &[] },
    Convention { name: "Biovision Example1", sides: LEFT_RIGHT,
        trunk: "*Hips > @Chest > *Neck > *Head",
        arm: "{}Collar > *{}UpArm > *{}LowArm > *{}Hand/end",
        leg: "*{}UpLeg > *{}LowLeg > *{}Foot/end", also: &[] },
    Convention { name: "Poser, DAZ", sides: ["l", "r"],
        trunk: "*hip > abdomen > @chest > *neck > *head",
        arm: "{}Collar > *{}Shldr > *{}ForeArm > *{}Hand > {}Mid1 > *{}Mid2",
        leg: "{}Buttock > *{}Thigh > *{}Shin > *{}Foot > *{}Toe",
        also: &["{}Hand > {}Thumb1 > {}Thumb2", "head > {}Eye"] },
    Convention { name: "Second Life", sides: ["Left", "Right"],
        trunk: "*mPelvis > mTorso > @mChest > *mNeck > *mHead",
        arm: "mCollar{} > *mShoulder{} > *mElbow{} > *mWrist{} > mHandMiddle1{} > *mHandMiddle2{}",
        leg: "*mHip{} > *mKnee{} > *mAnkle{} > mFoot{} > *mToe{}",
        also: &["mWrist{} > mHandThumb1{}", "mWrist{} > mHandRing1{} > mHandRing2{}"] },
    Convention { name: "Genesis 3 and 8", sides: ["l", "r"],
        trunk: "*hip > abdomenLower > abdomenUpper > @chestUpper > *neckLower > neckUpper > *head",
        arm: "{}Collar > *{}ShldrBend > {}ShldrTwist > *{}ForearmBend > {}ForearmTwist > *{}Hand > {}Carpal2 > {}Mid1 > *{}Mid2",
        leg: "*{}ThighBend > {}ThighTwist > *{}Shin > *{}Foot > {}Metatarsals > {}Toe > *{}BigToe",
        also: &["{}Toe > {}SmallToe1 > {}SmallToe1_2", "{}Hand > {}Thumb1 > {}Thumb2", "chestUpper > {}Pectoral"] },
    Convention { name: "Genesis 9", sides: ["l_", "r_"],
        trunk: "*hip > spine1 > @spine4 > *neck1 > neck2 > *head",
        arm: "{}shoulder > *{}upperarm > *{}forearm > *{}hand > {}mid1 > *{}mid2",
        leg: "*{}thigh > *{}shin > *{}foot > {}metatarsals > *{}toes",
        also: &["{}upperarm > {}upperarmtwist1", "{}hand > {}thumb1"] },
    Convention { name: "MocapNET", sides: ["l", "r"],
        trunk: "*hip > abdomen > @chest > *neck > *head",
        arm: "{}collar > *{}shoulder > *{}elbow > *{}hand > finger3-1.{} > *finger3-2.{}",
        leg: "{}buttock > *{}hip > *{}knee > *{}foot > *toe1-1.{}",
        also: &["{}hand > finger1-1.{} > finger1-2.{}", "{}hand > finger2-1.{}", "{}hand > finger4-1.{}", "{}hand > finger5-1.{}", "{}foot > toe5-1.{}"] },
    Convention { name: "ASF", sides: ["l", "r"],
        trunk: "*root > lowerback > upperback > @thorax > *lowerneck > upperneck > *head",
        arm: "{}clavicle > *{}humerus > *{}radius > *{}hand > *{}fingers",
        leg: "{}hipjoint > *{}femur > *{}tibia > *{}foot > *{}toes", also: &["{}hand > {}thumb"] },
    Convention { name: "SMPL", sides: ["L_", "R_"],
        trunk: "*Pelvis > Spine1 > Spine2 > @Spine3 > *Neck > *Head",
        arm: "{}Collar > *{}Shoulder > *{}Elbow > *{}Wrist > *{}Hand",
        leg: "*{}Hip > *{}Knee > *{}Ankle > *{}Foot", also: &[] },
    Convention { name: "AMASS", sides: ["l", "r"],
        trunk: "*root > lowerback > upperback > @chest > *lowerneck > *upperneck",
        arm: "{}clavicle > *{}shoulder > *{}elbow > *{}wrist/end",
        leg: "*{}hip > *{}knee > *{}ankle > *{}toe", also: &[] },
    Convention { name: "HumanML3D", sides: ["Left_", "Right_"],
        trunk: "*Pelvis > Spine1 > @Spine3 > *Neck > *Head",
        arm: "{}collar > *{}shoulder > *{}elbow > *{}wrist > *{}palm",
        leg: "*{}hip > *{}knee > *{}ankle > *{}foot", also: &[] },
    Convention { name: "Azure Kinect", sides: ["_LEFT", "_RIGHT"],
        trunk: "*PELVIS > SPINE_NAVAL > @SPINE_CHEST > *NECK > *HEAD",
        arm: "CLAVICLE{} > *SHOULDER{} > *ELBOW{} > *WRIST{} > HAND{} > *HANDTIP{}",
        leg: "*HIP{} > *KNEE{} > *ANKLE{} > *FOOT{}",
        also: &["WRIST{} > THUMB{}", "HEAD > EYE{}", "HEAD > EAR{}"] },
    Convention { name: "Kinect SDK", sides: ["Left", "Right"],
        trunk: "*HipCenter > Spine > @*ShoulderCenter > *Head",
        arm: "*Shoulder{} > *Elbow{} > *Wrist{} > *Hand{}",
        leg: "*Hip{} > *Knee{} > *Ankle{} > *Foot{}", also: &[] },
    Convention { name: "OpenNI", sides: ["LEFT", "RIGHT"],
        trunk: "*TORSO# > @*NECK# > *HEAD#",
        arm: "*{}_SHOULDER# > *{}_ELBOW# > *{}_HAND#/end",
        leg: "*{}_HIP# > *{}_KNEE# > *{}_FOOT#/end", also: &[] },
    Convention { name: "ZED", sides: ["LEFT", "RIGHT"],
        trunk: "*PELVIS > SPINE1 > @SPINE2 > *NECK > *HEAD",
        arm: "{}CLAVICLE > *{}SHOULDER > *{}ELBOW > *{}WRIST > *{}HANDMIDDLE4",
        leg: "*{}HIP > *{}KNEE > *{}ANKLE > *{}BIGTOE",
        also: &["{}WRIST > {}HANDTHUMB4", "{}ANKLE > {}HEEL", "{}ANKLE > {}SMALLTOE"] },
    Convention { name: "Sony mocopi", sides: ["l_", "r_"],
        trunk: "*root > torso_1 > @torso_7 > *neck_1 > neck_2 > *head",
        arm: "{}shoulder > *{}up_arm > *{}low_arm > *{}hand/end",
        leg: "*{}up_leg > *{}low_leg > *{}foot > *{}toes", also: &[] },
    Convention { name: "3ds Max Biped", sides: ["L", "R"],
        trunk: "*Bip01 Pelvis > Bip01 Spine > @Bip01 Spine1 > *Bip01 Neck > Bip01 Head > *Bip01 HeadNub",
        arm: "Bip01 {} Clavicle > *Bip01 {} UpperArm > *Bip01 {} Forearm > *Bip01 {} Hand > Bip01 {} Finger2 > *Bip01 {} Finger21",
        leg: "*Bip01 {} Thigh > *Bip01 {} Calf > *Bip01 {} Foot > Bip01 {} Toe0 > *Bip01 {} Toe0Nub",
        also: &["Bip01 {} Hand > Bip01 {} Finger0 > Bip01 {} Finger01 > Bip01 {} Finger0Nub", "Bip01 {} Hand > Bip01 {} Finger1 > Bip01 {} Finger11"] },
    Convention { name: "Reallusion", sides: ["L", "R"],
        trunk: "*CC_Base_Hip > CC_Base_Waist > @CC_Base_Spine02 > *CC_Base_NeckTwist01 > CC_Base_NeckTwist02 > *CC_Base_Head",
        arm: "CC_Base_{}_Clavicle > *CC_Base_{}_Upperarm > *CC_Base_{}_Forearm > *CC_Base_{}_Hand > CC_Base_{}_Mid1 > *CC_Base_{}_Mid2",
        leg: "*CC_Base_{}_Thigh > *CC_Base_{}_Calf > *CC_Base_{}_Foot > CC_Base_{}_ToeBase > *CC_Base_{}_BigToe1",
        also: &["CC_Base_{}_Thigh > CC_Base_{}_ThighTwist01", "CC_Base_{}_Hand > CC_Base_{}_Thumb1", "CC_Base_Head > CC_Base_{}_Eye"] },
    Convention { name: "MakeHuman", sides: ["L", "R"],
        trunk: "*root > spine05 > spine04 > @spine01 > *neck01 > neck02 > *head",
        arm: "clavicle.{} > shoulder01.{} > *upperarm01.{} > upperarm02.{} > *lowerarm01.{} > lowerarm02.{} > *wrist.{} > metacarpal2.{} > finger3-1.{} > *finger3-2.{}",
        leg: "pelvis.{} > *upperleg01.{} > upperleg02.{} > *lowerleg01.{} > lowerleg02.{} > *foot.{} > *toe1-1.{}",
        also: &["wrist.{} > finger1-1.{} > finger1-2.{} > finger1-3.{}", "metacarpal2.{} > finger2-1.{}", "wrist.{} > finger4-1.{} > finger4-2.{}", "wrist.{} > finger5-1.{}"] },
    Convention { name: "MakeHuman, old", sides: ["L", "R"],
        trunk: "*Root > Spine1 > @Spine3 > *Neck > *Head",
        arm: "__Clavicle_{} > Clavicle_{} > *UpArm_{} > *LoArm_{} > *Hand_{} > Middle1_{} > *Middle3_{}",
        leg: "__UpLeg_{} > *UpLeg_{} > *LoLeg_{} > *Foot_{} > *Toe_{}",
        also: &["Hand_{} > __Thumb1_{} > Thumb1_{}", "Head > __Eye_{} > Eye_{}"] },
    Convention { name: "Unreal", sides: ["l", "r"],
        trunk: "*pelvis > spine_01 > @spine_03 > *neck_01 > *head",
        arm: "clavicle_{} > *upperarm_{} > *lowerarm_{} > *hand_{} > middle_01_{} > *middle_02_{}",
        leg: "*thigh_{} > *calf_{} > *foot_{} > *ball_{}",
        also: &["lowerarm_{} > lowerarm_twist_01_{}", "thigh_{} > thigh_twist_01_{}", "hand_{} > thumb_01_{}"] },
    Convention { name: "Bandai Namco", sides: ["L", "R"],
        trunk: "*Hips > Spine > @Chest > *Neck > *Head",
        arm: "Shoulder_{} > *UpperArm_{} > *LowerArm_{} > *Hand_{}/end",
        leg: "*UpperLeg_{} > *LowerLeg_{} > *Foot_{} > *Toes_{}", also: &[] },
    Convention { name: "VRoid", sides: ["L", "R"],
        trunk: "*J_Bip_C_Hips > J_Bip_C_Spine > @J_Bip_C_UpperChest > *J_Bip_C_Neck > *J_Bip_C_Head",
        arm: "J_Bip_{}_Shoulder > *J_Bip_{}_UpperArm > *J_Bip_{}_LowerArm > *J_Bip_{}_Hand > J_Bip_{}_Middle1 > *J_Bip_{}_Middle2",
        leg: "*J_Bip_{}_UpperLeg > *J_Bip_{}_LowerLeg > *J_Bip_{}_Foot > *J_Bip_{}_ToeBase",
        also: &["J_Bip_C_Head > J_Sec_Hair1_01 > J_Sec_Hair2_01", "J_Bip_C_Head > J_Adj_{}_FaceEye"] },
    Convention { name: "VRM", sides: ["left", "right"],
        trunk: "*hips > spine > @chest > *neck > *head",
        arm: "{}Shoulder > *{}UpperArm > *{}LowerArm > *{}Hand > {}MiddleProximal > *{}MiddleDistal",
        leg: "*{}UpperLeg > *{}LowerLeg > *{}Foot > *{}Toes", also: &["{}Hand > {}ThumbProximal", "{}Hand > {}RingProximal > {}RingDistal"] },
    Convention { name: "DeepMotion", sides: ["l", "r"],
        trunk: "*hips_JNT > spine_JNT > @spine2_JNT > *neck_JNT > *head_JNT",
        arm: "{}_shoulder_JNT > *{}_arm_JNT > *{}_forearm_JNT > *{}_hand_JNT/end",
        leg: "*{}_upleg_JNT > *{}_leg_JNT > *{}_foot_JNT > *{}_toebase_JNT", also: &[] },
    Convention { name: "Rokoko", sides: LEFT_RIGHT,
        trunk: "*Hips > Spine1 > @Spine4 > *Neck > *Head",
        arm: "{}Shoulder > *{}Arm > *{}ForeArm > *{}Hand > {}Finger3Proximal > *{}Finger3Tip",
        leg: "*{}Thigh > *{}Shin > *{}Foot > *{}Toe",
        also: &["{}Hand > {}Finger1Proximal > {}Finger1Tip", "{}Hand > {}Finger2Tip", "{}Hand > {}Finger4Tip", "{}Hand > {}Finger5Tip"] },
    Convention { name: "OptiTrack Motive", sides: ["L", "R"],
        trunk: "*Hip > Ab > @Chest > *Neck > *Head",
        arm: "{}Shoulder > *{}UArm > *{}FArm > *{}Hand > {}Middle1 > *{}Middle3",
        leg: "*{}Thigh > *{}Shin > *{}Foot > *{}Toe", also: &["{}Hand > {}Thumb1 > {}Thumb3"] },
    Convention { name: "Blender Rigify", sides: ["L", "R"],
        trunk: "*spine > spine.001 > @spine.003 > *spine.004 > spine.005 > *spine.006",
        arm: "shoulder.{} > *upper_arm.{} > *forearm.{} > *hand.{} > palm.02.{} > f_middle.01.{} > *f_middle.02.{}",
        leg: "*thigh.{} > *shin.{} > *foot.{} > *toe.{}",
        also: &["foot.{} > heel.02.{}", "hand.{} > thumb.01.{}", "spine > pelvis.{}"] },
    Convention { name: "Rigify, deforming bones", sides: ["L", "R"],
        trunk: "*DEF-spine > DEF-spine.001 > @DEF-spine.003 > *DEF-spine.004 > *DEF-spine.006",
        arm: "DEF-shoulder.{} > *DEF-upper_arm.{} > *DEF-forearm.{} > *DEF-hand.{} > *DEF-f_middle.01.{}",
        leg: "*DEF-thigh.{} > *DEF-shin.{} > *DEF-foot.{} > *DEF-toe.{}", also: &[] },
    Convention { name: "MikuMikuDance", sides: ["左", "右"],
        trunk: "*センター > @上半身 > *首 > *頭",
        arm: "{}肩 > *{}腕 > {}腕捩 > *{}ひじ > {}手捩 > *{}手首 > {}中指１ > *{}中指２",
        leg: "*{}足 > *{}ひざ > *{}足首 > *{}つま先",
        also: &["{}手首 > {}親指１ > {}親指２", "{}手首 > {}薬指１ > {}薬指２", "頭 > {}目", "センター > {}足ＩＫ > {}つま先ＩＫ"] },
    Convention { name: "MediaPipe scripts", sides: LEFT_RIGHT,
        trunk: "*Hips > Spine > @Spine1 > *Neck > *Head",
        arm: "*{}Shoulder > *{}Arm > *{}ForeArm > *{}Hand",
        leg: "*{}UpLeg > *{}Leg > *{}Foot > *{}ToeBase", also: &[] },
    Convention { name: "names of the bone's end on the legs", sides: LEFT_RIGHT,
        trunk: "*Hips > Spine > @Spine1 > *Neck > *Head",
        arm: "{}Shoulder > *{}Arm > *{}ForeArm > *{}Hand/end",
        leg: "*{}Hip > *{}Thigh > *{}Shin > *{}Foot", also: &[] },
    Convention { name: "Perception Neuron", sides: LEFT_RIGHT,
        trunk: "*Hips > Spine > @Spine2 > *Neck > Neck1 > *Head",
        arm: "{}Shoulder > *{}Arm > *{}ForeArm > *{}Hand > {}InHandMiddle > {}HandMiddle1 > *{}HandMiddle2",
        leg: "*{}UpLeg > *{}Leg > *{}Foot > *{}Foot/end", also: &["{}Hand > {}HandThumb1", "{}Hand > {}InHandRing > {}HandRing1"] },
    Convention { name: "AdvancedSkeleton", sides: ["L", "R"],
        trunk: "*Root_M > Spine1_M > @Chest_M > *Neck_M > *Head_M",
        arm: "Scapula_{} > *Shoulder_{} > ShoulderPart1_{} > *Elbow_{} > *Wrist_{} > MiddleFinger1_{} > *MiddleFinger2_{}",
        leg: "*Hip_{} > HipPart1_{} > *Knee_{} > *Ankle_{} > *Toes_{}",
        also: &["Wrist_{} > ThumbFinger1_{} > ThumbFinger2_{} > ThumbFinger3_{}", "Wrist_{} > RingFinger1_{} > RingFinger2_{}"] },
    Convention { name: "Xsens segments", sides: LEFT_RIGHT,
        trunk: "*Pelvis > L5 > L3 > T12 > @T8 > *Neck > *Head",
        arm: "{}Shoulder > *{}UpperArm > *{}ForeArm > *{}Hand/end",
        leg: "*{}UpperLeg > *{}LowerLeg > *{}Foot > *{}Toe", also: &[] },
    Convention { name: "OpenPose", sides: ["L", "R"],
        trunk: "*MidHip > @*Neck > *Nose",
        arm: "*{}Shoulder > *{}Elbow > *{}Wrist/end",
        leg: "*{}Hip > *{}Knee > *{}Ankle > *{}BigToe", also: &["{}Ankle > {}Heel", "Nose > {}Eye > {}Ear"] },
    Convention { name: "Human3.6M from video", sides: LEFT_RIGHT,
        trunk: "*Hip > Spine > @Thorax > *Neck > *HeadEndSite",
        arm: "*{}Shoulder > *{}Elbow > *{}Wrist > *{}WristEndSite",
        leg: "*{}Hip > *{}Knee > *{}Ankle > *{}AnkleEndSite", also: &[] },
    Convention { name: "MediaPipe landmarks", sides: ["left_", "right_"],
        trunk: "*hips > @chest > *neck > *head",
        arm: "*{}shoulder > *{}elbow > *{}wrist > *{}index",
        leg: "*{}hip > *{}knee > *{}ankle > *{}foot_index", also: &["{}ankle > {}heel", "{}wrist > {}thumb"] },
    Convention { name: "Kinect 2", sides: LEFT_RIGHT,
        trunk: "*SpineBase > SpineMid > @SpineShoulder > *Neck > *Head",
        arm: "*Shoulder{} > *Elbow{} > *Wrist{} > Hand{} > *HandTip{}",
        leg: "*Hip{} > *Knee{} > *Ankle{} > *Foot{}", also: &["Hand{} > Thumb{}"] },
    Convention { name: "Auto-Rig Pro", sides: ["l", "r"],
        trunk: "*root.x > spine_01.x > @spine_02.x > *neck.x > *head.x",
        arm: "shoulder.{} > *arm_stretch.{} > *forearm_stretch.{} > *hand.{} > middle1.{} > *middle2.{}",
        leg: "*thigh_stretch.{} > *leg_stretch.{} > *foot.{} > *toes_01.{}",
        also: &["arm_stretch.{} > arm_twist.{}", "hand.{} > thumb1.{} > thumb2.{}"] },
    Convention { name: "Valve Biped", sides: ["L", "R"],
        trunk: "*ValveBiped.Bip01_Pelvis > ValveBiped.Bip01_Spine > @ValveBiped.Bip01_Spine4 > *ValveBiped.Bip01_Neck1 > *ValveBiped.Bip01_Head1",
        arm: "ValveBiped.Bip01_{}_Clavicle > *ValveBiped.Bip01_{}_UpperArm > *ValveBiped.Bip01_{}_Forearm > *ValveBiped.Bip01_{}_Hand > ValveBiped.Bip01_{}_Finger2 > *ValveBiped.Bip01_{}_Finger21",
        leg: "*ValveBiped.Bip01_{}_Thigh > *ValveBiped.Bip01_{}_Calf > *ValveBiped.Bip01_{}_Foot > *ValveBiped.Bip01_{}_Toe0",
        also: &["ValveBiped.Bip01_{}_Hand > ValveBiped.Bip01_{}_Finger0 > ValveBiped.Bip01_{}_Finger01", "ValveBiped.Bip01_{}_Hand > ValveBiped.Bip01_{}_Finger1"] },
    Convention { name: "limbs in numbered pieces", sides: ["L", "R"],
        trunk: "*Root > Spine > @Chest > *Neck > *Head",
        arm: "Shoulder_{} > *Arm1_{} > *Arm2_{} > *Hand_{}/end",
        leg: "*Leg1_{} > *Leg2_{} > *Foot_{}/end", also: &[] },
    Convention { name: "joints called joints", sides: LEFT_RIGHT,
        trunk: "*HipsJoint > SpineJoint > @ChestJoint > *NeckJoint > *HeadJoint",
        arm: "*{}ShoulderJoint > *{}ElbowJoint > *{}WristJoint/end",
        leg: "*{}HipJoint > *{}KneeJoint > *{}AnkleJoint > *{}ToeJoint", also: &[] },
    Convention { name: "Maya, no foot joint below the ankle, with namespaces", sides: ["L", "R"],
        trunk: "*Armature|rig:pelvis > rig:spine_1 > @rig:spine_2 > *rig:neck > *rig:head",
        arm: "rig:{}_clav > *rig:{}_armUpper > *rig:{}_armLower > *rig:{}_wrist/end",
        leg: "*rig:{}_legUpper > *rig:{}_legLower > *rig:{}_ankle/end", also: &["rig:{}_armUpper > rig:{}_armUpperRoll"] },
    Convention { name: "Japanese anatomy", sides: ["左", "右"],
        trunk: "*骨盤 > @胸 > *首 > *頭部",
        arm: "{}鎖骨 > *{}上腕 > *{}前腕 > *{}手/end",
        leg: "*{}大腿 > *{}下腿 > *{}足首 > *{}つま先", also: &[] },
    Convention { name: "Chinese", sides: ["左", "右"],
        trunk: "*骨盆 > @脊椎 > *脖子 > *头",
        arm: "{}肩 > *{}上臂 > *{}前臂 > *{}手/end",
        leg: "*{}大腿 > *{}小腿 > *{}脚/end", also: &[] },
    Convention { name: "lower case without separators", sides: ["left", "right"],
        trunk: "*hips > spine > @chest > *neck > *head",
        arm: "{}shoulder > *{}arm > *{}forearm > *{}hand/end",
        leg: "*{}upleg > *{}leg > *{}foot > *{}toebase", also: &[] },
];

/// The hierarchy that is being written, and the names of the roles met.
#[derive(Default)]
struct Writer {
    text: String,
    roles: Vec<(Role, String)>,
}

/// A joint of a chain: its name, and whether it takes the next role or carries the arms.
struct Link {
    name: String,
    is_role: bool,
    has_arms: bool,
    ends_in_role: bool,
}

fn links(chain: &str, side: &str) -> Vec<Link> {
    let link = |text: &str| {
        let name = text.trim_start_matches(['*', '@']);
        let marks = &text[..text.len() - name.len()];
        Link {
            name: name.trim_end_matches("/end").replace("{}", side),
            is_role: marks.contains('*'),
            has_arms: marks.contains('@'),
            ends_in_role: name.ends_with("/end"),
        }
    };
    chain.split(" > ").map(link).collect()
}

impl Writer {
    fn open(&mut self, name: &str, offset: [f64; 3]) {
        let keyword = if self.text.is_empty() {
            "HIERARCHY\nROOT"
        } else {
            "JOINT"
        };
        let [x, y, z] = offset;
        self.text += &format!(
            "{keyword} {name}\n{{\nOFFSET {x} {y} {z}\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
        );
    }

    fn end_site(&mut self, offset: [f64; 3]) {
        let [x, y, z] = offset;
        self.text += &format!("End Site\n{{\nOFFSET {x} {y} {z}\n}}\n");
    }

    fn close(&mut self) {
        self.text += "}\n";
    }

    /// What else hangs on a joint.
    fn also(&mut self, convention: &Convention, parent: &str, side: Side) {
        let sign = if side == Side::Left { 1.0 } else { -1.0 };
        for chain in convention.also {
            let links = links(chain, convention.sides[side.index()]);
            if links[0].name == parent {
                for link in &links[1..] {
                    self.open(&link.name, [sign * 2.5, 0.0, 2.0]);
                }
                self.end_site([sign * 0.1, 0.0, 0.0]);
                links[1..].iter().for_each(|_| self.close());
            }
        }
    }

    /// A limb: before its first role small steps, then the bones of `offsets`.
    fn limb(&mut self, convention: &Convention, chain: &str, side: Side, leg: bool) {
        let (roles, offsets) = match leg {
            true => (
                Role::leg(side),
                [
                    [8.0, -4.0, 0.0],
                    [0.0, -42.0, 0.0],
                    [0.0, -41.0, 0.0],
                    [0.0, -6.0, 14.0],
                ],
            ),
            false => (
                Role::arm(side),
                [
                    [14.0, 1.0, 0.0],
                    [27.0, 0.0, 0.0],
                    [25.0, 0.0, 0.0],
                    [9.0, 0.0, 0.0],
                ],
            ),
        };
        let sign = if side == Side::Left { 1.0 } else { -1.0 };
        let links = links(chain, convention.sides[side.index()]);
        let mut next = 0;
        let mut opened = 0;
        for link in &links {
            if link.is_role && self.roles.iter().any(|(_, name)| *name == link.name) {
                self.roles.push((roles[next], format!("{}/end", link.name)));
                continue;
            }
            let [x, y, z] = if link.is_role {
                offsets[next]
            } else {
                [0.6, -0.1, 0.1]
            };
            self.open(&link.name, [sign * x, y, z]);
            opened += 1;
            if link.is_role {
                self.roles.push((roles[next], link.name.clone()));
                next += 1;
            }
            if link.ends_in_role {
                self.roles.push((roles[3], format!("{}/end", link.name)));
            }
            self.also(convention, &link.name, side);
        }
        let is_end_of_foot = leg && next == 3;
        self.end_site(match next {
            3 if is_end_of_foot => offsets[3],
            3 => [sign * 9.0, 0.0, 0.0],
            _ => [0.0, 0.0, 0.0],
        });
        (0..opened).for_each(|_| self.close());
    }

    fn trunk(&mut self, convention: &Convention) {
        let mut roles = [Role::Pelvis, Role::Neck, Role::Head].into_iter();
        let links = links(convention.trunk, "");
        for (index, link) in links.iter().enumerate() {
            self.open(
                &link.name,
                [
                    0.0,
                    if index == 0 {
                        90.0
                    } else {
                        50.0 / links.len() as f64
                    },
                    0.0,
                ],
            );
            if link.is_role {
                self.roles
                    .push((roles.next().expect("three roles"), link.name.clone()));
            }
            for side in Side::BOTH {
                if index == 0 {
                    self.limb(convention, convention.leg, side, true);
                }
                if link.has_arms {
                    self.limb(convention, convention.arm, side, false);
                }
                self.also(convention, &link.name, side);
            }
        }
        self.end_site([0.0, 0.0, 0.0]);
        links.iter().for_each(|_| self.close());
    }
}

fn written(convention: &Convention) -> (Clip, Vec<(Role, String)>) {
    let mut writer = Writer::default();
    writer.trunk(convention);
    let channels = writer.text.matches("CHANNELS").count() * 3;
    writer.text += &format!(
        "MOTION\nFrames: 1\nFrame Time: 0.01\n{}\n",
        "0 ".repeat(channels)
    );
    let clip = motion::bvh::parse(writer.text.as_bytes()).expect("a motion");
    (clip, writer.roles)
}

#[test]
fn every_convention_is_understood() {
    let mut wrong = Vec::new();
    for convention in CONVENTIONS {
        let (clip, roles) = written(convention);
        let body = body::find(&clip, 0, &[]);
        let labels = clip.performers[0].skeleton.labels();
        if !body.is_human() {
            wrong.push(format!("{}: {:?}", convention.name, body.kind));
            continue;
        }
        assert_eq!(roles.len(), Role::ALL.len(), "{}", convention.name);
        for (role, name) in roles {
            let joint = body
                .joint(role)
                .map_or("none", |joint| labels[joint].as_str());
            if joint != name {
                wrong.push(format!(
                    "{}: {} is {joint}, not {name}",
                    convention.name,
                    role.name()
                ));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn there_are_fifty_conventions_or_more() {
    assert!(CONVENTIONS.len() >= 50);
}
