//! One clip: its bytes go in slice by slice, its analysis is made step by step, and arrays come out.

use motion::analysis::{Analyser, Analysis, KeyposeAnalysis, Survey};
use motion::bvh::Reader;
use motion::clip::Clip;
use motion::feature::ComparableFeature;
use motion::report::{self, Subject, Table, csv};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::settings::{self, JsDecisions, JsOptions};
use crate::{failure, poses, series, summary};

/// One clip in this memory. Free it once, with `free()`; results stay when its motion is dropped.
#[wasm_bindgen]
#[derive(Default)]
pub struct ClipHandle {
    reader: Option<Reader>,
    clip: Option<Clip>,
    has_motion: bool,
    analyser: Analyser,
    survey: Option<Survey>,
    analysis: Option<Analysis>,
}

#[wasm_bindgen]
impl ClipHandle {
    /// A handle without a clip.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Begins to read a file of `total_bytes` bytes.
    #[wasm_bindgen(js_name = beginReading)]
    pub fn begin_reading(&mut self, total_bytes: f64) {
        self.reader = Some(Reader::new(Some(total_bytes as u64)));
    }

    /// Reads the next bytes. Throws the failure of a file that cannot be read.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), JsError> {
        let Some(reader) = &mut self.reader else {
            return Err(failure::misuse("push: beginReading must come first"));
        };
        reader
            .push(bytes)
            .map_err(|error| failure::unreadable(&error))
    }

    /// Ends the reading. Throws the failure of a file that cannot be read.
    #[wasm_bindgen(js_name = endReading)]
    pub fn end_reading(&mut self) -> Result<(), JsError> {
        let Some(reader) = self.reader.take() else {
            return Err(failure::misuse("endReading: beginReading must come first"));
        };
        self.clip = Some(
            reader
                .finish()
                .map_err(|error| failure::unreadable(&error))?,
        );
        self.has_motion = true;
        Ok(())
    }

    /// Makes ready to analyse the clip. Throws the failure of a setting that cannot be.
    #[wasm_bindgen(js_name = beginAnalysis)]
    pub fn begin_analysis(
        &mut self,
        decisions: &JsDecisions,
        options: &JsOptions,
    ) -> Result<(), JsError> {
        let decisions = settings::decisions(decisions).map_err(|error| failure::refused(&error))?;
        let options = settings::options(options).map_err(|error| failure::refused(&error))?;
        let Some(clip) = self.clip.as_ref().filter(|_| self.has_motion) else {
            return Err(failure::misuse("beginAnalysis: there is no motion"));
        };
        self.survey = None;
        self.analysis = None;
        let begun = self.analyser.begin(clip, &decisions, &options);
        begun.map_err(|error| failure::refused(&error))
    }

    /// A few milliseconds of work. Returns the part done; 1 when the results are there.
    pub fn step(&mut self) -> Result<f64, JsError> {
        if self.analysis.is_some() {
            return Ok(1.0);
        }
        let Some(clip) = self.clip.as_ref().filter(|_| self.has_motion) else {
            return Err(failure::misuse("step: there is no motion"));
        };
        let done = self.analyser.step(clip);
        if done >= 1.0 {
            self.analysis = Some(self.analyser.analysis());
        }
        Ok(done)
    }

    /// A few milliseconds of work towards the survey alone, after `beginAnalysis`; `step` goes on from
    /// there. Returns the part done; 1 when the survey is there and postures can be had.
    #[wasm_bindgen(js_name = stepSurvey)]
    pub fn step_survey(&mut self) -> Result<f64, JsError> {
        let Some(clip) = self.clip.as_ref().filter(|_| self.has_motion) else {
            return Err(failure::misuse("stepSurvey: there is no motion"));
        };
        let done = self.analyser.step_survey(clip);
        if done >= 1.0 {
            self.survey = Some(self.analyser.survey());
        }
        Ok(done)
    }

    /// What the survey found, in words and single numbers, as JSON.
    pub fn survey(&self) -> Result<String, JsError> {
        let results = self.clip.as_ref().zip(self.survey.as_ref());
        let (clip, survey) = results.ok_or_else(|| failure::misuse("there is no survey yet"))?;
        Ok(summary::survey(clip, survey).text())
    }

    /// `count` analysed frames (the leading rest left out) from the `first` on: frames × 16 joints × 3,
    /// in body heights in the pelvis frame.
    pub fn postures(&self, performer: usize, first: u32, count: u32) -> Result<Vec<f64>, JsError> {
        let Some(track) = self.analyser.track(performer) else {
            return Err(failure::misuse("postures: stepSurvey must have said 1"));
        };
        let width = 3 * track.joint_count;
        let start = first as usize * width;
        let frames = track.coordinates.get(start..start + count as usize * width);
        let frames = frames.ok_or_else(|| failure::misuse("postures: the clip has fewer"))?;
        Ok(frames.to_vec())
    }

    /// What was found, in words and single numbers, as JSON.
    pub fn summary(&self) -> Result<String, JsError> {
        let (clip, analysis) = self.results()?;
        Ok(summary::summary(clip, analysis).text())
    }

    /// Results as text: `kind` is `keyposes`, `candidates` or `traces`, with `-csv` or `-json`.
    pub fn report(&self, kind: &str, file: &str, sha256: &str) -> Result<String, JsError> {
        let (clip, analysis) = self.results()?;
        let subject = Subject {
            file,
            sha256,
            clip,
            analysis,
        };
        let (name, form) = kind.rsplit_once('-').unwrap_or_default();
        let table = match name {
            "keyposes" => Table::Keyposes,
            "candidates" => Table::Candidates,
            "traces" => Table::Traces,
            _ => return Err(failure::misuse(&format!("report: unknown kind {kind}"))),
        };
        match form {
            "json" => Ok(report::json_lines(&subject, table, &[])),
            "csv" => Ok(csv::header(table).to_owned() + &csv::rows(&subject, table)),
            _ => Err(failure::misuse(&format!("report: unknown kind {kind}"))),
        }
    }

    /// Where the joints stand at the frames given: frames × joints × 3, in file units.
    pub fn poses(&self, performer: usize, frames: &[i32]) -> Result<Vec<f32>, JsError> {
        self.poses_at(performer, frames.iter().map(|frame| i64::from(*frame)))
    }

    /// The same for `count` frames from `first_frame` on.
    #[wasm_bindgen(js_name = poseRange)]
    pub fn pose_range(
        &self,
        performer: usize,
        first_frame: i32,
        count: u32,
    ) -> Result<Vec<f32>, JsError> {
        let frames = (0..count as usize).map(|index| i64::from(first_frame) + index as i64);
        self.poses_at(performer, frames)
    }

    /// The values of `count` rows from `first_row` on, as the file has them: rows × channels.
    pub fn rows(&self, first_row: u32, count: u32) -> Result<Vec<f64>, JsError> {
        let Some(clip) = self.clip.as_ref().filter(|_| self.has_motion) else {
            return Err(failure::misuse("rows: there is no motion"));
        };
        let start = first_row as usize * clip.row_width;
        let rows = clip
            .values
            .get(start..start + count as usize * clip.row_width);
        let rows = rows.ok_or_else(|| failure::misuse("rows: the clip has fewer"))?;
        Ok(rows.to_vec())
    }

    /// Whether poses can be had.
    #[wasm_bindgen(js_name = hasMotion)]
    pub fn has_motion(&self) -> bool {
        self.has_motion
    }

    /// Bytes that the motion takes.
    #[wasm_bindgen(js_name = motionBytes)]
    pub fn motion_bytes(&self) -> f64 {
        let values = self.clip.as_ref().map_or(0, |clip| clip.values.capacity());
        (values * size_of::<f64>() + self.analyser.motion_bytes()) as f64
    }

    /// Frees the motion; results stay, and the file can be read again.
    #[wasm_bindgen(js_name = dropMotion)]
    pub fn drop_motion(&mut self) {
        self.has_motion = false;
        self.reader = None;
        self.analyser.drop_motion();
        if let Some(clip) = &mut self.clip {
            clip.values = Vec::new();
        }
    }
}

/// The series of one performer (from 0); empty where there are none.
#[wasm_bindgen]
impl ClipHandle {
    /// Parent of each joint; −1 at the root.
    pub fn parents(&self, performer: usize) -> Vec<i32> {
        let parent = |joint: &motion::skeleton::Joint| joint.parent.map_or(-1, series::signed);
        self.joints(performer).iter().map(parent).collect()
    }

    /// 1 for each joint that is an End Site.
    #[wasm_bindgen(js_name = endSites)]
    pub fn end_sites(&self, performer: usize) -> Vec<u8> {
        self.joints(performer)
            .iter()
            .map(|joint| u8::from(joint.is_end_site))
            .collect()
    }

    /// The posture-variation feature: 12 numbers.
    pub fn feature(&self, performer: usize) -> Vec<f64> {
        let found = self
            .analysis
            .as_ref()
            .and_then(|all| series::performer(all, performer));
        found
            .and_then(|found| found.survey.feature)
            .map_or_else(Vec::new, Vec::from)
    }

    /// What is compared of a human performer, known from the survey on: the feature of the recorded
    /// body; 12 numbers.
    #[wasm_bindgen(js_name = recordedFeature)]
    pub fn recorded_feature(&self, performer: usize) -> Vec<f64> {
        self.comparable(performer, |found| found.recorded.to_vec())
    }

    /// The feature of the same motion on a body of standard lengths.
    #[wasm_bindgen(js_name = acrossRigsFeature)]
    pub fn across_rigs_feature(&self, performer: usize) -> Vec<f64> {
        self.comparable(performer, |found| found.across_rigs.to_vec())
    }

    /// What each joint adds to the recorded feature: 16 joints × 12.
    #[wasm_bindgen(js_name = recordedByJoint)]
    pub fn recorded_by_joint(&self, performer: usize) -> Vec<f64> {
        self.comparable(performer, |found| found.recorded_by_joint.concat())
    }

    /// What each joint adds to the feature on a body of standard lengths.
    #[wasm_bindgen(js_name = acrossRigsByJoint)]
    pub fn across_rigs_by_joint(&self, performer: usize) -> Vec<f64> {
        self.comparable(performer, |found| found.across_rigs_by_joint.concat())
    }

    /// Motion speed in body heights per second.
    pub fn speed(&self, performer: usize) -> Vec<f64> {
        self.series(performer, |found| found.speed.clone())
    }

    /// The slow part of the speed.
    pub fn trend(&self, performer: usize) -> Vec<f64> {
        self.series(performer, |found| found.trend.clone())
    }

    /// The time scales in Hz.
    #[wasm_bindgen(js_name = scalesHz)]
    pub fn scales_hz(&self, performer: usize) -> Vec<f64> {
        self.series(performer, |found| found.extraction.scales_hz.clone())
    }

    /// Frames of the candidates.
    pub fn candidates(&self, performer: usize) -> Vec<i32> {
        self.series(performer, |found| {
            series::file_frames(found, &found.extraction.candidates)
        })
    }

    /// Intensities of the candidates.
    pub fn intensities(&self, performer: usize) -> Vec<f64> {
        self.series(performer, |found| found.extraction.intensity.clone())
    }

    /// Where each candidate's trace begins, and where the last ends.
    #[wasm_bindgen(js_name = traceOffsets)]
    pub fn trace_offsets(&self, performer: usize) -> Vec<i32> {
        self.series(performer, |found| {
            series::signed_all(&found.extraction.traces.offsets)
        })
    }

    /// The scale of each entry of the traces.
    #[wasm_bindgen(js_name = traceScales)]
    pub fn trace_scales(&self, performer: usize) -> Vec<i32> {
        self.series(performer, |found| {
            series::trace_scales(&found.extraction.traces.offsets)
        })
    }

    /// The frame of each entry of the traces.
    #[wasm_bindgen(js_name = traceFrames)]
    pub fn trace_frames(&self, performer: usize) -> Vec<i32> {
        self.series(performer, |found| {
            series::file_frames(found, &found.extraction.traces.frames)
        })
    }

    /// What each entry of the traces adds to the intensity.
    #[wasm_bindgen(js_name = traceIntensities)]
    pub fn trace_intensities(&self, performer: usize) -> Vec<f64> {
        self.series(performer, |found| {
            found.extraction.traces.contributions.clone()
        })
    }

    /// Where each entry of the traces lies between the frames.
    #[wasm_bindgen(js_name = tracePlaces)]
    pub fn trace_places(&self, performer: usize) -> Vec<f64> {
        self.series(performer, series::trace_places)
    }

    /// Indices of the candidates from the most to the least intense.
    #[wasm_bindgen(js_name = byIntensity)]
    pub fn by_intensity(&self, performer: usize) -> Vec<i32> {
        self.series(performer, |found| {
            series::signed_all(&found.extraction.by_intensity())
        })
    }

    /// The scale at which each candidate is strongest; −1 without a trace.
    #[wasm_bindgen(js_name = strongestScales)]
    pub fn strongest_scales(&self, performer: usize) -> Vec<i32> {
        self.series(performer, series::strongest_scales)
    }

    /// Keyposes × parts of the body: the change there in percent; NaN where there is none.
    #[wasm_bindgen(js_name = bodyPartPercents)]
    pub fn body_part_percents(&self, performer: usize) -> Vec<f64> {
        self.series(performer, |found| {
            let changes = found.part_changes.iter().flatten();
            changes.map(|change| change.unwrap_or(f64::NAN)).collect()
        })
    }

    /// Joints whose trails are drawn at first.
    #[wasm_bindgen(js_name = trailJoints)]
    pub fn trail_joints(&self, performer: usize) -> Vec<i32> {
        let found = self
            .analysis
            .as_ref()
            .and_then(|all| series::performer(all, performer));
        found.map_or_else(Vec::new, |found| series::signed_all(&found.trail_joints))
    }

    /// Indices of the candidates that are keyposes.
    pub fn keyposes(&self, performer: usize) -> Vec<i32> {
        self.series(performer, |found| {
            series::signed_all(&found.extraction.selection.kept)
        })
    }
}

impl ClipHandle {
    fn results(&self) -> Result<(&Clip, &Analysis), JsError> {
        let results = self.clip.as_ref().zip(self.analysis.as_ref());
        results.ok_or_else(|| failure::misuse("there are no results yet"))
    }

    fn series<T>(&self, performer: usize, of: impl Fn(&KeyposeAnalysis) -> Vec<T>) -> Vec<T> {
        let found = self
            .analysis
            .as_ref()
            .and_then(|all| series::keyposes(all, performer));
        found.map_or_else(Vec::new, of)
    }

    fn comparable(
        &self,
        performer: usize,
        of: impl Fn(&ComparableFeature) -> Vec<f64>,
    ) -> Vec<f64> {
        let surveyed = self
            .survey
            .as_ref()
            .and_then(|all| all.performers.get(performer));
        let analysed = self
            .analysis
            .as_ref()
            .and_then(|all| all.performers.get(performer));
        let found = surveyed
            .and_then(|found| found.comparable.as_ref())
            .or(analysed.and_then(|found| found.survey.comparable.as_ref()));
        found.map_or_else(Vec::new, of)
    }

    fn joints(&self, performer: usize) -> &[motion::skeleton::Joint] {
        let owner = self
            .clip
            .as_ref()
            .and_then(|clip| clip.performers.get(performer));
        owner.map_or(&[], |owner| &owner.skeleton.joints)
    }

    fn poses_at(
        &self,
        performer: usize,
        frames: impl ExactSizeIterator<Item = i64>,
    ) -> Result<Vec<f32>, JsError> {
        let Some(clip) = self.clip.as_ref().filter(|_| self.has_motion) else {
            return Err(failure::misuse("poses: there is no motion"));
        };
        poses::poses(clip, performer, frames).map_err(|message| failure::misuse(&message))
    }
}
